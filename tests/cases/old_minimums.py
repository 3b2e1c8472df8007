"""Versions of CMake below 3.5, in repositories that name their distributions or do not (CMK002)."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example

OLD = {"CMakeLists.txt": CMAKE.replace("3.20", "3.3")}
BOTH = """\
if(ROS_EDITION STREQUAL "ROS1")
  cmake_minimum_required(VERSION {})
  project(my_pkg)
  find_package(catkin REQUIRED)
  catkin_package()
else()
  cmake_minimum_required(VERSION {})
  project(my_pkg)
  find_package(ament_cmake REQUIRED)
  ament_package()
endif()
"""

CASES = {
    "CMK002": (
        *(
            Example(bad={**OLD, "README.md": f"For {names}.\n"}, good={}, on="ament_cmake")
            for names in ("all", "Humble", "Humble and Jazzy", "Jazzy and Lyrical")
        ),
        *(
            Example(bad={"CMakeLists.txt": BOTH.format(*versions)}, good={}, on="ament_cmake")
            for versions in (("3.0", "3.14"), ("3.14", "3.0"))
        ),
        Example(bad={**OLD, "README.md": "For Humble.\n"}, good={}, on="ament_cmake", targets=("lyrical",)),
    ),
}
