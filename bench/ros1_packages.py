"""Write the table of packages that only ROS 1 ever had (src/rospkg_cli/ros/tables/ros1_packages.txt).

    python -m bench.ros1_packages ROSDISTRO [COMMIT DATE]

ROSDISTRO is a copy of ros/rosdistro with all distributions, those that ended too.  A name that a distribution of ROS 2
lists in any way (as a package or as a repository, released or not) is left out, and so is every rosdep key.
"""

from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

import yaml

from bench.names import grouped
from bench.tables import Origin, Revision, revision_of, write
from rospkg_cli.ros.names import BUILT_IN

ORIGIN = Origin("https://github.com/ros/rosdistro", "BSD-3-Clause", "bench/ros1_packages.py")
ABOUT = {"ros1_packages.txt": "Packages that only distributions of ROS 1 ever had, by the last one that had them."}
ROS1 = ("groovy", "hydro", "indigo", "jade", "kinetic", "lunar", "melodic", "noetic")
ROS2 = (
    "ardent", "bouncy", "crystal", "dashing", "eloquent", "foxy", "galactic", "humble", "iron", "jazzy", "kilted",
    "lyrical", "rolling",
)  # fmt: skip


def released(folder: Path, distro: str) -> Iterator[str]:
    """Yield the packages that a distribution released."""
    for name, repository in repositories(folder, distro):
        if "release" in repository:
            yield from repository["release"].get("packages", [name])


def repositories(folder: Path, distro: str) -> Iterable[tuple[str, Any]]:
    text = (folder / distro / "distribution.yaml").read_text(encoding="utf-8")
    found: dict[str, Any] = yaml.load(text, Loader=yaml.CSafeLoader)["repositories"]
    return found.items()


def main(folder: str, *revision: str) -> None:
    root = Path(folder)
    of_ros2 = {name for distro in ROS2 for name in released(root, distro)}
    of_ros2 |= {name for distro in ROS2 for name, _ in repositories(root, distro)}
    last = {name: (distro,) for distro in ROS1 for name in released(root, distro)}
    left = {
        name: mark
        for name, mark in last.items()
        if name not in of_ros2 and not BUILT_IN.is_package(name) and not BUILT_IN.is_key(name)
    }
    of = Revision(*revision) if revision else revision_of(root)
    write("ros1_packages.txt", ABOUT["ros1_packages.txt"], grouped(left), ORIGIN, of)


if __name__ == "__main__":
    main(*sys.argv[1:])
