"""One run from start to result: recording it, running it without ROS, and telling what came out."""
