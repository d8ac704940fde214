"""Where a recording and the simulation differ, what physics was left out, and how the fit improves with it."""
