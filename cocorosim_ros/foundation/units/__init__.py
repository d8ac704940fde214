"""Units: one table of all, and units as powers of their symbols."""
