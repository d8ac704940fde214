"""What happened: rosbag2 recordings in MCAP, written and read as raw CDR bytes, their digest, their poses."""
