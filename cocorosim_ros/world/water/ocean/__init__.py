"""From a netCDF file of an ocean model to velocity and density around the world's origin.

model_file: which variable is what; roms: its own grid; local_frame: degrees to metres; sea_water: density;
ocean_field: all of it for one tank and one run.
"""
