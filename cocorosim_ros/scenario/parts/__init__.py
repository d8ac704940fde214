"""What a scenario is made of: platforms, swarm, tank, water, controllers. Frozen records."""
