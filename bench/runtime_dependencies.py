"""Write the table of what comes with a package when it is installed (runtime_dependencies.txt in ros/tables).

    python -m bench.runtime_dependencies REPOSITORY…

Each is a git repository, with or without a work tree; read is the newest commit of its branch for each distribution
that is supported, and of its first branch.  The table holds facts alone: whoever installs the first name of a line gets
the others as well, since package.xml passes them on (`RUNS` and `EXPORTED`, which bloom makes the Depends of a Debian
package of); those with `?` on some distributions alone.
"""

from __future__ import annotations

import re
import subprocess
import sys
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

from bench.tables import Origin, Revision, write
from rospkg_cli.languages.rep149_condition import always_holds
from rospkg_cli.package.manifest import Manifest, manifest_of
from rospkg_cli.ros.distros import DISTROS, Targets
from rospkg_cli.ros.manifest import EXPORTED, RUNS
from rospkg_cli.ros.names import BUILT_IN
from rospkg_cli.source import Source
from rospkg_cli.unreadable import UnreadableError

Needs = tuple[set[str], set[str]]
"""What a package passes on for certain, and under a condition."""

TESTS = frozenset({"test", "tests", "testing"})
ROS2 = frozenset({"ament_cmake", "ament_python", "cmake"})
FOR_ROS2 = re.compile(r"ros2(?:[-_/](?:devel|main|release))?")
"""How the branch for ROS 2 is called in repositories whose first branch is for ROS 1."""
LEAVES = ("urdfdom_headers",)
"""Packages whose package.xml is in their release repository alone, and names no other package."""
RELEASED = {"pcl_conversions": ("libpcl-all-dev",), "pcl_ros": ("libpcl-all-dev",)}
"""What a release of a distribution passes on that has no branch of its own, where the common branch has moved on:
perception_pcl 2.4 of Humble."""
TABLE = "runtime_dependencies.txt"
ORIGIN = Origin(
    "package.xml of the repositories of these packages, the branches of Humble to Rolling",
    "Apache-2.0, BSD-3-Clause",
    "bench/runtime_dependencies.py",
)
ABOUT = {
    TABLE: "What is installed with a package: package, then what its package.xml passes on; with `?` what it passes on "
    "under a condition, or for some distributions alone. A package without any is here too: it is known to bring none."
}


def git(repository: Path, *arguments: str) -> str:
    command = ["git", "-C", str(repository), *arguments]
    return subprocess.run(command, check=True, capture_output=True, text=True, errors="replace").stdout


def branches(repository: Path) -> dict[str, str]:
    """Return the branch for each distribution; where none is called like it, the one for ROS 2, or the first."""
    refs = git(repository, "branch", "--all", "--format=%(refname)").split()
    names = {re.sub("^refs/(?:heads|remotes/[^/]+)/", "", each): each for each in refs}
    first = next((ref for name, ref in names.items() if FOR_ROS2.fullmatch(name)), "HEAD")
    found = dict.fromkeys((each.name for each in DISTROS), first)
    for distro in found:
        like = re.compile(rf"(?:ros2?[-/_])?{distro}(?:[-_/](?:devel|main|release))?")
        found[distro] = next((ref for name, ref in sorted(names.items()) if like.fullmatch(name)), first)
    return found


def manifests_at(repository: Path, branch: str) -> Iterator[Manifest]:
    """Yield the manifests of a branch, but for those of tests and of what can't be read."""
    for path in git(repository, "ls-tree", "-r", "--name-only", branch).splitlines():
        folders = Path(path).parts
        if folders[-1] == "package.xml" and not TESTS.intersection(folders):
            try:
                manifest = manifest_of(Source(path, git(repository, "show", f"{branch}:{path}")))
            except (UnreadableError, subprocess.CalledProcessError):
                continue
            if is_released(manifest):
                yield manifest


def is_released(manifest: Manifest) -> bool:
    return BUILT_IN.is_package(manifest.name) and manifest.build_type(Targets()) in ROS2


def passed_on(manifest: Manifest) -> Needs:
    """Return what a manifest passes on under conditions that always hold, and under others."""
    environments = Targets().environments()
    certain, perhaps = set[str](), set[str]()
    for each in manifest.dependencies:
        if each.tag in RUNS | EXPORTED and each.name != manifest.name:
            (certain if always_holds(each.condition, environments) else perhaps).add(each.name)
    return certain, perhaps - certain


def closure(name: str, graph: Mapping[str, Needs]) -> set[str]:
    """Return all that certainly comes with a package on one distribution."""
    found: set[str] = set()
    waiting = [name]
    while waiting:
        new = graph.get(waiting.pop(), (set(), set()))[0] - found
        found |= new
        waiting += new
    return found


def row(name: str, graphs: Sequence[Mapping[str, Needs]]) -> str:
    """Return the line of a package: what it names on any distribution, `?` before what does not come on all."""
    here = [graph for graph in graphs if name in graph]
    every = set[str]().union(*(certain | perhaps for certain, perhaps in (graph[name] for graph in here)))
    certain = every.intersection(*(closure(name, graph) for graph in here))
    perhaps = every.union(RELEASED.get(name, ())) - certain
    return " ".join([name, *sorted(certain), *(f"?{each}" for each in sorted(perhaps))])


def main(repositories: Sequence[Path]) -> None:
    graphs: dict[str, dict[str, Needs]] = {each.name: dict.fromkeys(LEAVES, (set(), set())) for each in DISTROS}
    days = []
    for repository in repositories:
        days.append(git(repository, "log", "-1", "--format=%cs").strip())
        wanted = branches(repository)
        read = {branch: list(manifests_at(repository, branch)) for branch in {"HEAD", *wanted.values()}}
        for distro, branch in wanted.items():
            for manifest in read[branch] or read["HEAD"]:
                if distro in BUILT_IN.packages[manifest.name]:
                    graphs[distro][manifest.name] = passed_on(manifest)
    names = sorted(set[str]().union(*graphs.values()))
    rows = [row(name, [*graphs.values()]) for name in names]
    write(TABLE, ABOUT[TABLE], rows, ORIGIN, Revision("unknown", max(days)))


if __name__ == "__main__":
    main([Path(each) for each in sys.argv[1:]])
