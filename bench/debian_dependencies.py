"""Write the table of what Debian installs with a rosdep key (debian_dependencies.txt in ros/tables).

    apt-get update; apt-cache dumpavail | python -m bench.debian_dependencies ROSDISTRO

ROSDISTRO is a git repository of ros/rosdistro.  Between two keys may lie packages that no key stands for; only
`Depends` and `Pre-Depends` count, and of alternatives the first.  Debian's and Ubuntu's packages differ little in this;
keys of which Debian has no package are left out.
"""

from __future__ import annotations

import re
import subprocess
import sys
from collections.abc import Iterable, Iterator, Mapping
from datetime import date
from pathlib import Path

import yaml

from bench.tables import Origin, Revision, write
from rospkg_cli.ros.names import BUILT_IN
from rospkg_cli.ros.read_table import rows as table_rows

OF_ROS = {"python3-catkin-pkg-modules": {"python3-dateutil", "python3-docutils", "python3-pyparsing"}}
"""Packages of the apt repository of ROS, which Debian has under another name."""
TABLE = "debian_dependencies.txt"
ORIGIN = Origin(
    "the index of Debian 12, main, and ros/rosdistro", "LicenseRef-facts, BSD-3-Clause", "bench/debian_dependencies.py"
)
ABOUT = {
    TABLE: "What Debian installs with a rosdep key: key, then the other keys. A key without any is "
    "here too: it is known to bring none. Packages that libraries.txt names and that are no keys count as such."
}


def packages(text: str) -> Iterator[tuple[str, list[str]]]:
    """Yield each package of an index with those that it depends on."""
    for paragraph in text.split("\n\n"):
        fields = dict(line.split(": ", 1) for line in paragraph.splitlines() if ": " in line and line[0] != " ")
        needs = ", ".join(fields[key] for key in ("Pre-Depends", "Depends") if key in fields)
        if "Package" in fields:
            words = (each.split("|")[0].split("(")[0].strip().split(":")[0] for each in needs.split(","))
            yield fields["Package"], [word for word in words if word]


def apt_packages(rosdistro: Path) -> Iterator[tuple[str, tuple[str, ...]]]:
    """Yield each key of rosdep's lists with the packages that apt installs for it on Debian, else on Ubuntu."""
    for name in ("base.yaml", "python.yaml"):
        command = ["git", "-C", str(rosdistro), "show", f"HEAD:rosdep/{name}"]
        listed = yaml.safe_load(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
        for key, systems in listed.items():
            found = of_system(systems.get("debian")) or of_system(systems.get("ubuntu"))
            if found and BUILT_IN.is_key(key):
                yield key, found


def of_libraries() -> Iterator[str]:
    """Yield the packages with a library of which the key has several (`libavcodec-dev` of `ffmpeg`)."""
    for part in ("headers", "linked", "modules"):
        serving = (name for names in table_rows("libraries.txt", part).values() for name in names)
        yield from (name for name in serving if not BUILT_IN.is_key(name))


def of_system(rule: object) -> tuple[str, ...]:
    match rule:
        case list():
            return tuple(str(each) for each in rule)
        case {"apt": {"packages": list(packages)}}:
            return tuple(str(each) for each in packages)
        case {"pip": _} | {"source": _}:
            return ()
        case dict():
            every = (of_system(rule.get(codename)) for codename in ("bookworm", "*", "jammy", "noble"))
            return next((each for each in every if each), ())
    return ()


def brought(
    own: str, first: Iterable[str], needs: Mapping[str, list[str]], keys: Mapping[str, str]
) -> tuple[set[str], set[str]]:
    """Return the keys of what comes with the packages of a key, and these packages, as far as no other key lies
    between.
    """
    found: set[str] = set()
    seen = set(first)
    met = set(first)
    waiting = [*first]
    while waiting:
        for other in needs.get(waiting.pop(), ()):
            met.add(other)
            if keys.get(other, own) != own:
                found.add(keys[other])
            elif other not in seen:
                seen.add(other)
                waiting.append(other)
    return found, met


def inside(found: Iterable[str], listed: Mapping[str, tuple[str, ...]]) -> set[str]:
    """Return the keys all of whose packages are among some: `python3-pyqt5` is inside of `python3-qt5-bindings`."""
    there = {*found}
    return {key for key, others in listed.items() if len(others) > 1 and there.issuperset(others)}


def main(rosdistro: Path) -> None:
    needs = dict(packages(sys.stdin.read()))
    listed = {**{name: (name,) for name in of_libraries()}, **dict(apt_packages(rosdistro))}
    keys = {found[0]: key for key, found in sorted(listed.items(), reverse=True) if len(found) == 1}
    keys |= {key: key for key, found in listed.items() if found == (key,)}
    for key, found in listed.items():  # of a library in several versions Debian has a name for the default one
        first = needs.get(found[0], ()) if len(found) == 1 else ()
        if len(first) == 1 and re.sub(r"[\d.]+", "", first[0]) == found[0]:
            keys.setdefault(first[0], key)
    rows = dict[str, set[str]]()
    for key, found in listed.items():
        if all(each in needs for each in found):
            others, met = brought(key, found, needs, keys)
            rows[key] = others | {keys[each] for each in found if each in keys} | inside(met, listed)
    rows |= OF_ROS
    lines = [" ".join([key, *sorted(others - {key})]) for key, others in sorted(rows.items())]
    write(TABLE, ABOUT[TABLE], lines, ORIGIN, Revision("unknown", date.today().isoformat()))


if __name__ == "__main__":
    main(Path(sys.argv[1]))
