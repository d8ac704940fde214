"""Swarms of underwater robots on ROS 2.

The folders are the flow of the data, and each may import those above it only:

    errors        what goes wrong, as a sentence for the person who can mend it
    compilation   how hot loops are compiled
    scenario      what is asked: arena, swarm, water, rates, seed
    signals       what flows between the stages: frozen records of arrays
    environment   the world: walls, floor, surface, water
    physics       how vehicles move
    media         who hears whom
    sensors       what a robot perceives
    controllers   what a robot decides; it knows its own observation and nothing else
    simulation    one tick of all of these, in order
    messages      signals as ROS messages in CDR bytes, without ROS
    recording     what happened, as a rosbag2 folder
    metrics       how well the swarm did
    calibration   from measurements to the numbers of a platform
    pictures      the run as a figure
    nodes, runs   the ROS shell (the only folder that imports rclpy), and the same run in one process or many
    commands      the command `cocorosim`
"""

__version__ = "0.1.0"
