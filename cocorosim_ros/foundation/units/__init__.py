"""Units as powers of their symbols."""
