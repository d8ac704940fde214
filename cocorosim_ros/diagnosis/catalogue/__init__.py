"""What a diagnosis looks for: effects by the contract's identifiers, and laws outside the catalogue."""
