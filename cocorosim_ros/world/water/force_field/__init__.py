"""Currents as the paper has them: forces on patches of water that spread, decay, are made by cold spots and thrusters.

One step, in the order of the authors' model: diffusion, decay, cold spots, thrusters.
"""
