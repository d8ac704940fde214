"""The ROS shell: the only folder that imports rclpy. It converts, schedules and publishes; it computes nothing."""
