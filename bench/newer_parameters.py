"""Write the table of parameters that Humble's packages do not declare, and newer ones do (newer_parameters.txt).

    python -m bench.newer_parameters FOLDER

FOLDER holds bare mirrors, `owner+name/repo` each; those that are not there are left out.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path

from bench.tables import Origin, write
from bench.well_known import branches, facts_in, git, mirrored
from bench.well_known_parameters import ASIDE, is_plain

TABLE = "newer_parameters.txt"
SOURCES = ("*.cpp", "*.hpp", "*.h", "*.py", ":(glob)**/src/**/*.yaml")
OLDEST = ("humble", "humble-devel")
REPOSITORIES = (
    "ros-navigation/navigation2", "SteveMacenski/slam_toolbox", "ros-controls/ros2_controllers",
    "ros-controls/ros2_control", "cra-ros-pkg/robot_localization", "moveit/moveit2", "RobotWebTools/rosbridge_suite",
    "realsenseai/realsense-ros",
)  # fmt: skip
ABOUT = {
    TABLE: "Parameters that well-known packages declare from Iron, Jazzy or later on, and whose names no source on "
    "their branches for Humble has: package, then each name. Behind `*` stands what follows a part that is known at "
    "run time only."
}
ORIGIN = Origin(
    "calls that declare parameters and definitions for generate_parameter_library in the repositories that the script "
    "lists, their branches from Humble on",
    "Apache-2.0, BSD-3-Clause, LGPL-2.1",
    "bench/newer_parameters.py",
)
Names = dict[str, set[str]]


def main(folder: Path) -> None:
    there = [name for name in REPOSITORIES if (folder / name.replace("/", "+")).is_dir()]
    mirrors, revision = mirrored(folder, there)
    write(TABLE, ABOUT[TABLE], sorted(row for mirror in mirrors for row in rows(mirror)), ORIGIN, revision)


def rows(mirror: Path) -> Iterator[str]:
    """Yield a row for each package of which Humble has a version, and which has got more since."""
    current = [branch for branch, is_current in branches(mirror) if is_current]
    oldest = next((branch for branch in current if branch in OLDEST), None)
    if oldest is None:
        return
    before, now = names_on(mirror, [oldest]), names_on(mirror, [each for each in current if each != oldest])
    words = words_on(mirror, oldest)
    for package in sorted(before.keys() & now.keys()):
        newer = sorted(each for each in now[package] - before[package] if each.rpartition(".")[2] not in words)
        if newer:
            yield " ".join([package, *newer])


def words_on(mirror: Path, branch: str) -> frozenset[str]:
    """Return the words of the sources on a branch: they may declare what is not read there, by other means."""
    found = git(mirror, "grep", "-h", "-I", "-o", "-w", "-E", "[A-Za-z_][A-Za-z0-9_]*", branch, "--", *SOURCES)
    return frozenset(found.decode("utf-8", "replace").split())


def names_on(mirror: Path, branches_read: list[str]) -> Names:
    found: Names = {}
    for facts in (facts for branch in branches_read for facts in facts_in(mirror, branch)):
        if not any(word in facts.name for word in ASIDE):
            plain = {("*" if each.tail else "") + each.name for each in facts.parameters if is_plain(each)}
            found.setdefault(facts.name, set()).update(plain)
    return found


if __name__ == "__main__":
    main(Path(sys.argv[1]))
