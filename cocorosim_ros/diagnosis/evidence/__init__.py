"""Readings and commands of each robot: read, cleaned, put on one clock, and checked before any physics is fitted."""
