# ROS 2 Jazzy with this tree built by colcon, by the steps of docs/how_to/install.md.
#     docker build -t cocorosim_ros . && docker run -it --rm cocorosim_ros
FROM ros:jazzy-ros-base

RUN apt-get update && apt-get install -y --no-install-recommends python3-venv python3-pip

WORKDIR /opt/cocorosim_ros
COPY . .

RUN python3 -m venv --system-site-packages env && . env/bin/activate && \
    pip install numba llvmlite 'ruamel.yaml>=0.18' rosbags zstandard lz4 pyarrow markupsafe colcon-common-extensions && \
    rosdep update && \
    rosdep install --from-paths . msg_defs --ignore-src -y && \
    . /opt/ros/jazzy/setup.sh && \
    python -m colcon build --base-paths . msg_defs

RUN echo '. /opt/cocorosim_ros/env/bin/activate && . /opt/cocorosim_ros/install/setup.bash' >> /etc/bash.bashrc
CMD ["bash"]
