"""How hot loops are compiled: kernels and their cache, tables of functions, vectors of four, angles with fixed bits."""
