"""One robot in one recording: its readings on a grid, and the filter's pass over them."""
