"""Foretelling: free runs of models through what no fit saw, against readings, and the noise floor beside them."""
