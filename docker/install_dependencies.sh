#!/usr/bin/env bash
# Installs everything that building, testing and running semantic_slam needs, from Debian 12's own
# package archive. Safe to run again: it asks apt only for what is missing.
#   docker/install_dependencies.sh [--print]     --print lists the packages and installs nothing
set -euo pipefail

packages=(
  # tools
  build-essential ca-certificates ccache cmake git ninja-build procps python3-pytest
  # ROS 1 Noetic as packaged by Debian: build system, client library, message packages
  catkin ros-message-generation ros-message-runtime
  libroscpp-dev librosbag-dev librosbag-storage-dev libcv-bridge-dev libimage-transport-dev libmessage-filters-dev
  libnodelet-dev libnodeletlib-dev pluginlib-dev libdiagnostic-updater-dev
  libdynamic-reconfigure-config-init-mutex-dev libtf2-dev libtf2-ros-dev libtf2-eigen-dev
  libtf2-geometry-msgs-dev libtf2-msgs-dev libpcl-conversions-dev libpcl-ros-dev
  libstd-msgs-dev libsensor-msgs-dev libgeometry-msgs-dev libnav-msgs-dev
  libvisualization-msgs-dev libdiagnostic-msgs-dev libros-rosgraph-msgs-dev libstd-srvs-dev
  ros-std-msgs ros-sensor-msgs ros-geometry-msgs ros-nav-msgs ros-visualization-msgs
  ros-diagnostic-msgs ros-actionlib-msgs ros-rosgraph-msgs ros-tf2-msgs ros-std-srvs
  # ROS tools that launch files and tests start
  python3-roslaunch python3-rosbag python3-rosnode python3-rosparam python3-rosservice
  python3-rostopic python3-rosmsg python3-rostest python3-rosunit python3-rospy
  librostest-dev libtopic-tools-dev libnodeletlib-tools tf2-tools image-transport-tools topic-tools rosbash roslang
  python3-rosmaster rosout rviz python3-std-srvs
  python3-std-msgs python3-sensor-msgs python3-geometry-msgs python3-nav-msgs
  python3-visualization-msgs python3-diagnostic-msgs python3-rosgraph-msgs python3-tf2-msgs
  python3-numpy python3-nodelet python3-dynamic-reconfigure
  # libraries
  libceres-dev libeigen3-dev libembree-dev liboctomap-dev libssl-dev libopencv-dev libpcl-dev libyaml-cpp-dev nlohmann-json3-dev
  libboost-all-dev libgtest-dev libgmock-dev libbenchmark-dev
  # pictures: rviz without a display, and a look at it
  xvfb xauth libgl1-mesa-dri scrot x11-utils
)

if [[ "${1:-}" == --print ]]; then
  printf '%s\n' "${packages[@]}"
  exit 0
fi

missing=()
for package in "${packages[@]}"; do
  dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
done
if ((${#missing[@]} == 0)); then
  echo "dependencies: all ${#packages[@]} packages are installed"
  exit 0
fi

as_root=()
if ((EUID != 0)); then as_root=(sudo); fi
echo "dependencies: installing ${#missing[@]} of ${#packages[@]} packages"
"${as_root[@]}" apt-get update -q
DEBIAN_FRONTEND=noninteractive "${as_root[@]}" apt-get install -q -y --no-install-recommends \
  "${missing[@]}"
