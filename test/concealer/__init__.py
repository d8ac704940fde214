"""The Concealer and the Scorer of the sealed-envelope trial: a program of its own.

It writes recordings of Lily-like robots in which something is hidden, seals what it hid, and scores the answers.
It shares no line with cocorosim_ros: physics, smaller steps and other functional forms, written from the
interface's text alone, so that the tool is not examined by a copy of itself (test/architecture checks the imports).

    layout        what a robot and its water are made of: one vector of numbers
    physics       surge, sway, heave, yaw; how numbers make a trajectory
    water         random forces with a Matern-3/2 spectrum
    manoeuvres    programmes of commands
    catalogue     the effects of the interface's table: how each is drawn, hidden and reported
    outside       effects that no catalogue has
    truth_after   parameters that only the trajectory defines (equivalents of other functional forms)
    sensors       what camera, compass, pressure sensor and IMU make of a trajectory
    bag           recordings as rosbag2 folders
    prior         the registered prior: which recording gets what
    recording     one recording from one seed
    oracle        free runs of a model that knows the truth
    seal          salted hashes, published before the tool runs
    score         truths against diagnoses
    tamper        known alterations of the logs of any recording
"""
