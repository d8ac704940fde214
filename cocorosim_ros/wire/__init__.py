"""What leaves and enters the process: messages as CDR bytes, topics, bags, other people's logs. Without ROS."""
