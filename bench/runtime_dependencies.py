"""Write the table of what comes with a package when it is installed (runtime_dependencies.txt in ros/tables).

    python -m bench.runtime_dependencies REPOSITORY…

Each is a git repository, with or without a work tree; its newest commit is read.  The table holds facts alone: whoever
installs the first name of a line gets the others as well, on every distribution, since package.xml passes them on
(`RUNS` and `EXPORTED`, which bloom makes the Depends of a Debian package of).
"""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path

from bench.tables import Origin, Revision, write
from rospkg_cli.languages.rep149_condition import always_holds
from rospkg_cli.package.manifest import Manifest, manifest_of
from rospkg_cli.ros.distros import Targets
from rospkg_cli.ros.manifest import EXPORTED, RUNS
from rospkg_cli.ros.names import BUILT_IN
from rospkg_cli.source import Source
from rospkg_cli.unreadable import UnreadableError

TESTS = frozenset({"test", "tests", "testing"})
ROS2 = frozenset({"ament_cmake", "ament_python", "cmake"})
BRANCHES = ("ros2", "rolling")
"""Where ROS 2 is, in repositories whose first branch is for ROS 1."""
TABLE = "runtime_dependencies.txt"
ORIGIN = Origin(
    "package.xml of the repositories of these packages, Rolling",
    "Apache-2.0, BSD-3-Clause",
    "bench/runtime_dependencies.py",
)
ABOUT = {
    TABLE: "What is installed with a package: package, then what its package.xml passes on under conditions that hold "
    "for every distribution."
}


def git(repository: Path, *arguments: str) -> str:
    command = ["git", "-C", str(repository), *arguments]
    return subprocess.run(command, check=True, capture_output=True, text=True, errors="replace").stdout


def manifests(repository: Path) -> list[Manifest]:
    """Return the manifests of packages of ROS 2, of the first branch that has some."""
    branches = git(repository, "branch", "--format=%(refname:short)").split()
    for branch in ("HEAD", *(each for each in BRANCHES if each in branches)):
        if found := [each for each in manifests_at(repository, branch) if is_released(each)]:
            return found
    return []


def manifests_at(repository: Path, branch: str) -> Iterator[Manifest]:
    """Yield the manifests of a branch, but for those of tests and of what can't be read."""
    for path in git(repository, "ls-tree", "-r", "--name-only", branch).splitlines():
        folders = Path(path).parts
        if folders[-1] == "package.xml" and not TESTS.intersection(folders):
            try:
                yield manifest_of(Source(path, git(repository, "show", f"{branch}:{path}")))
            except UnreadableError:
                continue


def is_released(manifest: Manifest) -> bool:
    return BUILT_IN.is_package(manifest.name) and manifest.build_type(Targets()) in ROS2


def passed_on(manifest: Manifest) -> set[str]:
    environments = Targets().environments()
    return {
        each.name
        for each in manifest.dependencies
        if each.tag in RUNS | EXPORTED and always_holds(each.condition, environments)
    }


def main(repositories: Sequence[Path]) -> None:
    found: dict[str, set[str]] = {}
    days = []
    for repository in repositories:
        days.append(git(repository, "log", "-1", "--format=%cs").strip())
        for manifest in manifests(repository):
            found.setdefault(manifest.name, passed_on(manifest))
    rows = [" ".join([name, *sorted(needs - {name})]) for name, needs in sorted(found.items()) if needs]
    write(TABLE, ABOUT[TABLE], rows, ORIGIN, Revision("unknown", max(days)))


if __name__ == "__main__":
    main([Path(each) for each in sys.argv[1:]])
