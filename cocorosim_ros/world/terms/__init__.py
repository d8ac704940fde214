"""What effects and laws are made of: places where they act, regressors, the circumstances of one moment."""
