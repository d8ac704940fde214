"""What must hold between the parts of a scenario before the model can run it; scenarios are loaded and checked here."""
