"""Write the table of the defaults of the parameters of well-known nodes (known_defaults.txt in ros/tables).

    python -m bench.known_defaults FOLDER

FOLDER holds bare mirrors, `owner+name/repo` each.  A default is written where every declaration of the parameter on
every branch from Dashing on has it: what it is may not depend on the release that somebody has.
"""

from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator
from pathlib import Path

from bench.tables import Origin, write
from bench.well_known import branches, facts_in, mirrored
from bench.well_known_parameters import ASIDE, is_plain
from rospkg_cli.package.package_facts import PackageFacts
from rospkg_cli.ros.known_nodes import is_same_value

TABLE = "known_defaults.txt"
REPOSITORIES = (
    "ros-navigation/navigation2", "SteveMacenski/slam_toolbox", "ros-controls/ros2_controllers",
    "ros-controls/ros2_control", "cra-ros-pkg/robot_localization", "ros-drivers/joystick_drivers",
    "ros-drivers/usb_cam", "ros-drivers/velodyne", "ros-perception/pointcloud_to_laserscan",
    "ros-teleop/teleop_twist_joy", "ros-teleop/twist_mux", "ros/ros_tutorials",
)  # fmt: skip
ABOUT = {
    TABLE: "What the parameters of well-known packages are where nothing is given, alike on all branches that have "
    "them: package, then each `name=value`. Behind `*` stands what follows a part that is known at run time only."
}
ORIGIN = Origin(
    "calls that declare parameters and definitions for generate_parameter_library in the repositories that the script "
    "lists, their branches from Dashing on",
    "Apache-2.0, BSD-2-Clause, BSD-3-Clause, LGPL-2.1, MIT",
    "bench/known_defaults.py",
)
LONGEST = 60
Found = dict[tuple[str, str], list[str]]
"""The defaults by package and name, "" for each that is not known."""


def main(folder: Path) -> None:
    mirrors, revision = mirrored(folder, REPOSITORIES)
    found: Found = {}
    for mirror in mirrors:
        for branch, _ in branches(mirror):
            add(found, facts_in(mirror, branch))
    write(TABLE, ABOUT[TABLE], sorted(rows(found)), ORIGIN, revision)


def add(found: Found, packages: Iterable[PackageFacts]) -> None:
    """Add what some packages declare on one branch."""
    for facts in packages:
        for each in facts.parameters if not any(word in facts.name for word in ASIDE) else ():
            if is_plain(each):
                name = ("*" if each.tail else "") + each.name
                found.setdefault((facts.name, name), []).append(each.default)


def rows(found: Found) -> Iterator[str]:
    known: dict[str, list[str]] = {}
    for (package, name), defaults in found.items():
        first = defaults[0]
        if is_word(first) and all(is_same_value(each, first) for each in defaults):
            known.setdefault(package, []).append(f"{name}={first}")
    for package, pairs in known.items():
        yield " ".join([package, *sorted(pairs)])


def is_word(value: str) -> bool:
    """Return whether a default can stand in a row, where a blank or a sign of the table would end or change it."""
    return bool(value) and len(value) <= LONGEST and not any(sign.isspace() or sign in "=*[]#" for sign in value)


if __name__ == "__main__":
    main(Path(sys.argv[1]))
