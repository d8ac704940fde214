"""Laws outside the catalogue: forces and errors of readings in proportion to products of regressors."""
