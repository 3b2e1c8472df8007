"""Write the built-in tables of names (src/rospkg_cli/ros/tables) from a copy of ros/rosdistro.

    python bench/names.py ROSDISTRO

The tables hold facts alone: which names exist, in which distribution, by which installer a key is served, and what it
is called there.
"""

from __future__ import annotations

import sys
from collections import defaultdict
from collections.abc import Iterable, Mapping
from pathlib import Path

from rospkg_cli.index.file_url import place_of
from rospkg_cli.index.update import make_index
from rospkg_cli.ros.distros import DISTROS
from rospkg_cli.ros.name_index import Named
from rospkg_cli.ros.rosdep import CODENAMES

TABLES = Path(__file__).parents[1] / "src/rospkg_cli/ros/tables"


def write(name: str, says: str, lines: Iterable[str]) -> None:
    text = "\n".join([f"# {says} Written by bench/names.py.", *lines]) + "\n"
    (TABLES / name).write_text(text, encoding="utf-8")


def grouped(named: Named) -> Iterable[str]:
    """Yield the names under the `[heading]` of their mark, both in order."""
    groups: dict[str, list[str]] = defaultdict(list)
    for name, mark in sorted(named.items()):
        groups[" ".join(mark)].append(name)
    for heading, names in sorted(groups.items()):
        yield from (f"[{heading}]", *names)


def rows(named: Mapping[str, tuple[str, ...]]) -> Iterable[str]:
    return sorted(f"{name} {key}" for name, keys in named.items() for key in keys)


def main(folder: str) -> None:
    index = make_index(place_of(folder, {}, ""), [each.name for each in DISTROS], {"ROSDEP_SOURCE_PATH": ""})
    write("packages.txt", "Released ROS packages, by the distributions that have them.", grouped(index.packages))
    heading = f"Keys of rosdep, by the installer on Ubuntu {', '.join(CODENAMES)} (- where there is none)."
    write("keys.txt", heading, grouped(index.keys))
    write("pip.txt", "Names on PyPI and the key that installs them, where it is not called like them.", rows(index.pip))
    says = "Packages of Ubuntu and the key that stands for them alone, where no key is called like them."
    write("apt.txt", says, rows(index.apt))


if __name__ == "__main__":
    main(sys.argv[1])
