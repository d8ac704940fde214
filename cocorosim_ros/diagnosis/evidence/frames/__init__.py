"""Checks of axes, signs and units: streams that are not in those of the contract are corrected before any fit."""
