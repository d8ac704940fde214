"""Are the streams in the axes, signs and units of the contract? Asked before any physics is blamed."""
