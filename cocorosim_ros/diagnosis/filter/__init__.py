"""The compiled filter of the diagnosis: its passes over a recording, its smoother, and the products of slopes."""
