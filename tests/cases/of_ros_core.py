"""Test frameworks outside of `if(BUILD_TESTING)` that are not declared, and whether ros_core brings them (CMK107)."""

from __future__ import annotations

from .idioms_of_cmake import package

OFF = {"build.sh": "colcon build --cmake-args -DBUILD_TESTING=OFF\n"}

CASES = {
    "CMK107": (
        package("find_package(ament_lint_auto REQUIRED)\n", {}),
        package("find_package(ament_lint_auto REQUIRED)\n", OFF),
        package("find_package(ros_testing REQUIRED)\n", {}),
        package("find_package(ament_lint_auto REQUIRED)\nfind_package(ros_testing REQUIRED)\n", {}),
    ),
}
