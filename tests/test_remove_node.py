"""`rospkg remove node` knows a node by its source, whatever interface, topic and quality it was asked for with."""

from __future__ import annotations

import pytest
from adding import added, cmake_package, comes_back, python_package

from rospkg_cli.example import SETUP_PY

PYTHON = python_package(SETUP_PY)
CMAKE = cmake_package(
    "cmake_minimum_required(VERSION 3.20)\nproject(my_pkg)\n\nfind_package(ament_cmake REQUIRED)\n\n"
    "add_executable(old src/old.cpp)\ninstall(TARGETS old DESTINATION lib/${PROJECT_NAME})\n\nament_package()\n"
)
SEVERAL = "subscriber:sensor_msgs/Imu@/imu:sensor_data+publisher:geometry_msgs/Twist@/cmd_vel+service:std_srvs/SetBool"


@pytest.mark.parametrize(
    ("files", "asked"),
    [
        (PYTHON, "service:std_srvs/SetBool"),
        (PYTHON, "action-client:example_interfaces/Fibonacci@go"),
        (PYTHON, "publisher:geometry_msgs/Twist@/cmd_vel:transient_local"),
        (CMAKE, "subscriber:@/scan"),
        (CMAKE, SEVERAL),
    ],
)
def test_what_add_wrote_is_taken_away_without_force(files: dict[str, str], asked: str) -> None:
    draft = added(files, "node", f"idler:{asked}")
    comes_back(files, draft, "node", "idler")
