"""Write the built-in tables of names (src/rospkg_cli/ros/tables) from a copy of ros/rosdistro.

    python -m bench.names ROSDISTRO [COMMIT DATE]

The tables hold facts alone: which names exist, in which distribution, by which installer a key is served, and what it
is called there.  Commit and date are those of the checkout; a copy that is none has them named.
"""

from __future__ import annotations

import sys
from collections import defaultdict
from collections.abc import Iterable, Mapping
from pathlib import Path

from bench.tables import Origin, Revision, revision_of, write
from rospkg_cli.index.file_url import index_url
from rospkg_cli.index.update import make_index
from rospkg_cli.ros.distros import DISTROS
from rospkg_cli.ros.name_index import Named
from rospkg_cli.ros.rosdep import CODENAMES

ORIGIN = Origin("https://github.com/ros/rosdistro", "BSD-3-Clause", "bench/names.py")
ABOUT = {
    "packages.txt": "Released ROS packages, by the distributions that have them.",
    "keys.txt": f"Keys of rosdep, by the installer on Ubuntu {', '.join(CODENAMES)} (- where there is none).",
    "pip.txt": "Names on PyPI and the key that installs them, where it is not called like them.",
    "apt.txt": "Packages of Ubuntu and the key that stands for them alone, where no key is called like them.",
}


def grouped(named: Named) -> Iterable[str]:
    """Yield the names under the `[heading]` of their mark, both in order."""
    groups: dict[str, list[str]] = defaultdict(list)
    for name, mark in sorted(named.items()):
        groups[" ".join(mark)].append(name)
    for heading, names in sorted(groups.items()):
        yield from (f"[{heading}]", *names)


def rows(named: Mapping[str, tuple[str, ...]]) -> Iterable[str]:
    return sorted(f"{name} {key}" for name, keys in named.items() for key in keys)


def main(folder: str, *revision: str) -> None:
    index = make_index(index_url(folder, {}, ""), [each.name for each in DISTROS], {"ROSDEP_SOURCE_PATH": ""})
    of = Revision(*revision) if revision else revision_of(Path(folder))
    tables = {
        "packages.txt": grouped(index.packages),
        "keys.txt": grouped(index.keys),
        "pip.txt": rows(index.pip),
        "apt.txt": rows(index.apt),
    }
    for name, lines in tables.items():
        write(name, ABOUT[name], lines, ORIGIN, of)


if __name__ == "__main__":
    main(*sys.argv[1:])
