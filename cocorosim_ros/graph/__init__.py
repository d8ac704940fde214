"""The ROS node graph, and the same run in one process."""
