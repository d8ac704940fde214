"""How robots move: effects add up to a wrench, the wrench accelerates, an integrator takes the step."""
