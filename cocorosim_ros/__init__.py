"""Swarms of underwater robots on ROS 2.

The wings are the flow of the data, and each may import those above it only:

    foundation    what all else stands on: errors as sentences, units, how hot loops are compiled
    scenario      what is asked: arena, swarm, water, rates, seed
    world         the model: how robots move, sense, talk and decide, and in what water
    wire          messages as bytes, topics, recordings, other people's logs; without ROS
    study         shoaling statistics, many runs at once, calibration, the claims of the paper
    graph         the ROS nodes (the only ones that import rclpy), and the same run in one process
    diagnosis     where a recording and the model differ, and what physics is missing
    commands      the command `cocorosim`
"""

__version__ = "0.2.0"
