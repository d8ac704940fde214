"""The wire form of every topic, without ROS: types and their texts, fast CDR encoding, names and QoS.

Nothing here imports rclpy or a message package; the bytes are those that rclpy sends and receives.
"""
