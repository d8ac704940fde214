"""Thresholds of the diagnosis, one frozen record for each decision; every field gives its unit, reason and measurement.

Sizes of grids, orders of differences and constants of nature are no thresholds; they stand beside the algorithm.
"""
