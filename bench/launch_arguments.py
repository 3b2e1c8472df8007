"""Write the table of what launch files of well-known packages take (launch_arguments.txt in ros/tables).

    python -m bench.launch_arguments FOLDER

FOLDER holds bare mirrors, `owner+name/repo` each.  Of every repository the branches of the supported distributions and
the newest one are read as `rospkg lint` reads a workspace.  What any of them takes is written.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path

from bench.tables import Origin, write
from bench.well_known import branches, facts_in, mirrored
from bench.well_known_renames import REPOSITORIES
from rospkg_cli.package.launch.included_arguments import IncludedArguments
from rospkg_cli.package.package_facts import PackageFacts
from rospkg_cli.ros.distros import DISTROS

TABLE = "launch_arguments.txt"
ABOUT = {
    TABLE: "Arguments that launch files of well-known packages take in the supported distributions, themselves or by "
    "what they include: package and path in its share directory, then each name."
}
ORIGIN = Origin(
    "launch files in the repositories that bench/well_known_renames.py lists, their branches from Humble on",
    "Apache-2.0, BSD-2-Clause, BSD-3-Clause, EPL-2.0, LGPL-2.1, LGPL-3.0, MIT",
    "bench/launch_arguments.py",
)
ASIDE = ("example", "tutorial", "test", "moveit_resources")
"""Words in the names of packages whose launch files nobody includes."""
NEWEST = "HEAD"
Taken = dict[str, set[str]]
"""Package and path of a launch file, with what it takes."""


def main(folder: Path) -> None:
    by_distro: dict[str, list[PackageFacts]] = {name: [] for name in (*(each.name for each in DISTROS), NEWEST)}
    mirrors, revision = mirrored(folder, REPOSITORIES)
    for mirror in mirrors:
        here = {branch.removesuffix("-devel"): facts_in(mirror, branch) for branch, now in branches(mirror) if now}
        for distro, facts in by_distro.items():
            facts += here.get(distro, here[NEWEST])
    found: Taken = {}
    for facts in by_distro.values():
        add(found, facts)
    write(TABLE, ABOUT[TABLE], rows(found), ORIGIN, revision)


def add(found: Taken, packages: list[PackageFacts]) -> None:
    """Add what the launch files of a distribution take; they include each other across repositories."""
    arguments = IncludedArguments((facts.name, each) for facts in packages for each in facts.launch_files)
    for facts in packages:
        for each in facts.launch_files if not any(word in facts.name for word in ASIDE) else ():
            names, _ = arguments.names_in(facts.name, each.source)
            for place in each.places:
                if " " not in place:
                    found.setdefault(f"{facts.name}/{place}", set()).update(names)


def rows(found: Taken) -> Iterator[str]:
    for file, names in sorted(found.items()):
        if names:
            yield " ".join([file, *sorted(name for name in names if " " not in name)])


if __name__ == "__main__":
    main(Path(sys.argv[1]))
