"""The compiled loops of the diagnosis."""
