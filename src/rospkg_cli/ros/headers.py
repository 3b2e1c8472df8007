"""Where C++ headers come from: the first folder of an include, and the CMake package or ROS package behind it."""

from __future__ import annotations

from collections.abc import Mapping

LIBRARIES: Mapping[str, str] = {
    "Eigen": "Eigen3",
    "GeographicLib": "GeographicLib",
    "boost": "Boost",
    "ceres": "Ceres",
    "CGAL": "CGAL",
    "fmt": "fmt",
    "gflags": "gflags",
    "glog": "glog",
    "nlohmann": "nlohmann_json",
    "opencv2": "OpenCV",
    "pcl": "PCL",
    "pybind11": "pybind11",
    "spdlog": "spdlog",
    "yaml-cpp": "yaml-cpp",
}
"""Folders of libraries, by the name that find_package has for them."""

SHARED = frozenset({"moveit", "ros", "gz", "ignition", "autoware", "nav2", "rclcpp_components_"})
"""Folders that several packages put headers into, or that are no package's at all."""
