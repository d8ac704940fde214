"""Many runs without ROS: a design becomes chunks of runs, and these become a table with one row a run."""
