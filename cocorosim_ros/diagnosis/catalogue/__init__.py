"""The catalogue: effects that a diagnosis looks for, by the contract's identifiers, and laws outside the catalogue."""
