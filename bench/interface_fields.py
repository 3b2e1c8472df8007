"""Write ros/tables/interface_fields.txt: the messages, services and actions of packages that many use, with fields.

python -m bench.interface_fields MIRRORS

MIRRORS is a folder of bare clones, `owner+name/repo` each.  What any of the branches for a supported distribution has
is written, so that a name which is not in the table, and is near one that is, is misspelt.
"""

from __future__ import annotations

import argparse
import subprocess
from collections.abc import Iterator
from pathlib import Path

from rospkg_cli.package.interfaces.interface_file import Member
from rospkg_cli.package.interfaces.text import parse_interface
from rospkg_cli.ros.interfaces import KINDS
from rospkg_cli.source import Source

from .tables import Origin, Revision, write

REPOSITORIES = """
ros2/common_interfaces ros2/rcl_interfaces ros2/geometry2 ros2/unique_identifier_msgs ros2/example_interfaces
ros-controls/control_msgs ros-controls/ros2_control ros-navigation/navigation2 moveit/moveit_msgs
ros-perception/vision_msgs ros-drivers/ackermann_msgs ros-geographic-info/geographic_info gazebosim/ros_gz
ros-simulation/simulation_interfaces iRobotEducation/irobot_create_msgs ros/ros_tutorials ros-drivers/nmea_msgs
SteveMacenski/slam_toolbox ros-planning/navigation_msgs OctoMap/octomap_msgs ros-perception/pcl_msgs
wg-perception/object_recognition_msgs
""".split()
BRANCHES = ("humble", "iron", "jazzy", "kilted", "lyrical", "rolling", "humble-devel", "main", "ros2", "master")
ASIDE = frozenset({"test", "tests", "test_msgs", "nav2_system_tests", "roscpp_tutorials", "rospy_tutorials"})

ABOUT = {
    "interface_fields.txt": (
        "The fields and constants of interfaces that many packages use, from all branches for supported distributions. "
        "Behind `:` stands the message that a field holds one of, without its package where that is the same. "
        "Later distributions may add to them."
    )
}
ORIGIN = Origin(
    "interface files of " + ", ".join(REPOSITORIES),
    "Apache-2.0, BSD-3-Clause",
    "bench/interface_fields.py",
)


def git(clone: Path, *words: str, asked: bytes | None = None) -> bytes:
    return subprocess.run(["git", "--git-dir", str(clone), *words], check=True, capture_output=True, input=asked).stdout


def branches(clone: Path) -> list[str]:
    """Return the branches for ROS 2; `master` is that of ROS 1 where there is one called ros2."""
    have = git(clone, "for-each-ref", "--format=%(refname:short)", "refs/heads").decode().split()
    found = [name for name in BRANCHES if name in have]
    return [name for name in found if name != "master" or "ros2" not in found]


def interface_files(clone: Path, branch: str) -> Iterator[tuple[str, str]]:
    """Yield the path and the text of each interface file of a branch, but for tests."""
    for line in git(clone, "ls-tree", "-r", branch).decode().splitlines():
        meta, path = line.split("\t", 1)
        if path.rpartition(".")[2] in KINDS and ASIDE.isdisjoint(path.split("/")):
            yield path, git(clone, "cat-file", "blob", meta.split()[2]).decode("utf-8", "replace")


def packages(clone: Path, branch: str) -> dict[str, str]:
    """Return the name of the package in each folder of a branch."""
    found = {}
    for path in git(clone, "ls-tree", "-r", "--name-only", branch).decode().splitlines():
        if path.rpartition("/")[2] == "package.xml":
            text = git(clone, "cat-file", "blob", f"{branch}:{path}").decode("utf-8", "replace")
            found[path.rpartition("/")[0]] = text.partition("<name>")[2].partition("</name>")[0].strip()
    return found


def package_of(path: str, folders: dict[str, str]) -> str:
    while path:
        path = path.rpartition("/")[0]
        if path in folders:
            return folders[path]
    return ""


def word(member: Member, package: str) -> str:
    kind = member.type
    if member.is_constant or kind.is_primitive or kind.is_array:
        return member.name
    return f"{member.name}:{kind.base if kind.package in ('', package) else f'{kind.package}/{kind.base}'}"


def read(clone: Path) -> dict[str, dict[str, str]]:
    """Return the words of each message of a repository, by the name of their fields."""
    found: dict[str, dict[str, str]] = {}
    for branch in branches(clone):
        folders = packages(clone, branch)
        for path, text in interface_files(clone, branch):
            package, kind = package_of(path, folders), path.rpartition(".")[2]
            if not package:
                continue
            interface = parse_interface(Source(path, text), kind)
            for section in interface.sections:
                fields = found.setdefault(f"{package}/{kind}/{interface.name}{section.suffix}", {})
                fields |= {member.name: word(member, package) for member in section.members}
    return found


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mirrors", type=Path)
    clones = [parser.parse_args().mirrors / name.replace("/", "+") / "repo" for name in REPOSITORIES]
    messages: dict[str, dict[str, str]] = {}
    days = []
    for clone in clones:
        messages |= read(clone)
        days += [git(clone, "log", "-1", "--format=%cs", branch).decode().strip() for branch in branches(clone)]
    rows = [" ".join([name, *sorted(messages[name].values())]) for name in sorted(messages)]
    tips = f"the tips of {', '.join(BRANCHES)}"
    write("interface_fields.txt", ABOUT["interface_fields.txt"], rows, ORIGIN, Revision(tips, max(days)))


if __name__ == "__main__":
    main()
