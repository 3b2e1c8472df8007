"""Write the built-in tables of names (src/rospkg_cli/ros/tables) from a copy of ros/rosdistro.

    python bench/names.py ROSDISTRO

The tables hold facts alone: which names exist, in which distribution, and by which installer a key is served.
"""

from __future__ import annotations

import sys
from collections import defaultdict
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

import yaml

from rospkg_cli.ros.distros import DISTROS
from rospkg_cli.ros.rosdep import CODENAMES, installer, pip_names

TABLES = Path(__file__).parents[1] / "src/rospkg_cli/ros/tables"
LISTS = ("base", "python", "ruby", "osx-homebrew")


def read(path: Path) -> dict[str, Any]:
    loaded = yaml.load(path.read_text(encoding="utf-8"), Loader=yaml.CSafeLoader)
    assert isinstance(loaded, dict)
    return loaded


def packages(folder: Path, name: str) -> set[str]:
    """Return the names of the packages that a distribution has released."""
    released: dict[str, Mapping[str, Any]] = read(folder / name / "distribution.yaml")["repositories"]
    return {
        package
        for repository, entry in released.items()
        if "release" in entry
        for package in entry["release"].get("packages", [repository])
    }


def grouped(marks: Iterable[tuple[str, str]]) -> dict[str, list[str]]:
    """Return the names by their mark, both in order."""
    groups: dict[str, list[str]] = defaultdict(list)
    for name, mark in sorted(marks):
        groups[mark].append(name)
    return dict(sorted(groups.items()))


def write(name: str, says: str, groups: Mapping[str, Iterable[str]]) -> None:
    lines = [f"# {says} Written by bench/names.py."]
    for mark, names in groups.items():
        lines += [f"[{mark}]", *names] if mark else [*names]
    (TABLES / name).write_text("\n".join(lines) + "\n", encoding="utf-8")


def main(folder: Path) -> None:
    by_distro = {each.name: packages(folder, each.name) for each in DISTROS}
    marks = {
        name: " ".join(distro for distro, names in by_distro.items() if name in names)
        for name in set().union(*by_distro.values())
    }
    write("packages.txt", "Released ROS packages, by the distributions that have them.", grouped(marks.items()))
    keys: dict[str, Any] = {}
    for each in LISTS:
        keys |= read(folder / "rosdep" / f"{each}.yaml")
    served = {key: " ".join(installer(entry, c) for c in CODENAMES.values()) for key, entry in keys.items()}
    heading = f"Keys of rosdep, by the installer on Ubuntu {', '.join(CODENAMES)} (- where there is none)."
    write("keys.txt", heading, grouped(served.items()))
    codenames = CODENAMES.values()
    pips = {(pip, key) for key, entry in keys.items() for codename in codenames for pip in pip_names(entry, codename)}
    lines = sorted(f"{pip} {key}" for pip, key in pips if not same(pip, key))
    write("pip.txt", "Names on PyPI and the key that installs them, where it is not called like them.", {"": lines})


def same(pip: str, key: str) -> bool:
    """Return whether a key is called like the name on PyPI, so that nobody needs to be told."""
    return key == f"python3-{pip.lower().replace('_', '-').replace('.', '-')}-pip"


if __name__ == "__main__":
    main(Path(sys.argv[1]))
