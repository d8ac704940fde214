"""A first look at any robot's recording without a model: clocks, rates, frozen readings, covariances, frames, units."""
