"""What swarms did: shoaling statistics, many runs at once, pictures, calibration, the claims of the paper."""
