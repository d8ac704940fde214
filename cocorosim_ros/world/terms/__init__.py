"""What effects and laws are made of: equations, readings and regressors, laws, the circumstances of one moment."""
