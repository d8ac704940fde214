"""What was found, as facts: estimates, residuals, location, free runs."""
