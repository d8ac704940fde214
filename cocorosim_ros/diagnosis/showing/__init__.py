"""Facts about the findings: estimates, residuals, location, free runs."""
