"""Tests of the shoaling statistics."""
