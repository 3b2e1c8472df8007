"""`rospkg remove node` knows a node by its source, whatever interface, topic and quality it was asked for with."""

from __future__ import annotations

import pytest
from adding import added, cmake_package, comes_back, python_package, taken, text

from rospkg_cli.change.draft import Draft
from rospkg_cli.example import SETUP_PY

PYTHON = python_package(SETUP_PY)
CMAKE = cmake_package(
    "cmake_minimum_required(VERSION 3.20)\nproject(my_pkg)\n\nfind_package(ament_cmake REQUIRED)\n\n"
    "add_executable(old src/old.cpp)\ninstall(TARGETS old DESTINATION lib/${PROJECT_NAME})\n\nament_package()\n"
)


def all_files(draft: Draft) -> dict[str, str]:
    return {path: text(draft, path) for path in draft.tree.files()}


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


INSTALLED = "install(TARGETS old DESTINATION lib/${PROJECT_NAME})\nament_python_install_package(${PROJECT_NAME})\n"


@pytest.mark.parametrize("found", ["find_package(ament_cmake_python REQUIRED)\n", ""])
def test_a_python_package_that_was_installed_before_stays(found: str) -> None:
    cmake = (
        f"cmake_minimum_required(VERSION 3.20)\nproject(my_pkg)\n\nfind_package(ament_cmake REQUIRED)\n{found}"
        f"add_executable(old src/old.cpp)\n{INSTALLED}\ninstall(PROGRAMS\n  scripts/old\n"
        "  DESTINATION lib/${PROJECT_NAME}\n)\n\nament_package()\n"
    )
    files = cmake_package(cmake, **{"my_pkg/__init__.py": "", "scripts/old": "#!/usr/bin/env python3\n"})
    before = added(files, "node", "idler:empty:python")
    after, _ = taken(before, "node", "idler")
    assert text(after, "CMakeLists.txt") == cmake
    assert after.entry("my_pkg/__init__.py") is not None


@pytest.mark.parametrize(
    ("files", "first", "second"),
    [
        (CMAKE, "one:publisher:python", "two:publisher"),  # what it declares is needed by Python too
        (PYTHON, "one:tf-listener", "two:tf-listener"),  # the name that Python imports is not the package's
    ],
)
def test_the_second_is_taken_away_from_the_first(files: dict[str, str], first: str, second: str) -> None:
    before = all_files(added(files, "node", first))
    draft = added(before, "node", second)
    comes_back(before, draft, "node", "two")


def test_what_each_language_needed_goes_with_the_last_of_them() -> None:
    draft = added(all_files(added(CMAKE, "node", "one:publisher:python")), "node", "two:publisher")
    after, exact = taken(draft, "node", "one", "two")
    assert "rcl_interfaces" not in text(after, "package.xml") + text(after, "CMakeLists.txt")
    assert not exact
