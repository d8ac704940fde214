"""Random numbers by name: one seed to independent generators, the random start of a swarm, draws tick by tick."""
