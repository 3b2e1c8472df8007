"""Does our index say what rosdep and rosdistro themselves say of the same data?

    index_truth.py --source FOLDER [--python PYTHON] [--show N]

FOLDER is a copy of ros/rosdistro; PYTHON has rosdep and rosdistro.  rosdep gets a ROS_HOME and a sources.list.d of its
own, with file URLs into the copy, and is asked for every key of every list and every package of every distribution, on
the Ubuntu release that goes with each (REP-2000); so are names that nobody has.  Both the index that `rospkg index
update` would keep and the tables that are built in are compared, and how long it takes to read the index back.
"""

from __future__ import annotations

import argparse
import json
import os
import re
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

import yaml

from rospkg_cli.index.file_url import index_url
from rospkg_cli.index.rosdep_lists import DEFAULT_LISTS, rosdep_lists
from rospkg_cli.index.rosdistro_files import document
from rospkg_cli.index.update import make_index
from rospkg_cli.ros.distros import DISTROS, Distro
from rospkg_cli.ros.name_index import check, dump, parse
from rospkg_cli.ros.names import BUILT_IN, FetchedNames, Names
from rospkg_cli.ros.rosdep import CODENAMES, NOT_THERE, merged, packages

HERE = Path(__file__).parent
UPDATE = "from rosdep2.main import rosdep_main; rosdep_main(['update'])"
NOBODYS = ("opencv-python", "my_companys_driver", "sensor_msg", "libeigen3-dev", "Eigen3", "python3-rclpy", "rospy")
Verdicts = Mapping[str, Sequence[Any]]


def prepare(source: Path, home: Path) -> dict[str, str]:
    """Return the environment in which rosdep knows the copy alone; `rosdep update` is still to be run."""
    index = yaml.safe_load((source / "index-v4.yaml").read_text())
    wanted = {each.name for each in DISTROS}
    index["distributions"] = {
        name: {**entry, "distribution": [(source / path).as_uri() for path in entry["distribution"]]}
        for name, entry in index["distributions"].items()
        if name in wanted
    }
    (home / "index-v4.yaml").write_text(yaml.safe_dump(index))
    (home / "lists").mkdir()
    lists = (source / DEFAULT_LISTS).read_text()
    own = re.sub(r"https://\S+?/(rosdep/\S+\.yaml)", lambda found: (source / found[1]).as_uri(), lists)
    (home / "lists/20-default.list").write_text("".join(f"{x}\n" for x in own.splitlines() if x[:4] == "yaml"))
    kept = {key: value for key, value in os.environ.items() if not key.startswith("ROS")}
    return {
        **kept,
        "ROS_HOME": str(home),
        "ROSDEP_SOURCE_PATH": str(home / "lists"),
        "ROSDISTRO_INDEX_URL": (home / "index-v4.yaml").as_uri(),
    }


def rosdep(python: str, environment: Mapping[str, str], distro: Distro, names: Sequence[str]) -> Verdicts:
    command = [python, str(HERE / "rosdep_verdicts.py"), distro.name, CODENAMES[distro.ubuntu]]
    text = "".join(f"{name}\n" for name in names)
    done = subprocess.run(command, input=text, env=environment, capture_output=True, text=True, check=True)
    return dict(zip(names, map(json.loads, done.stdout.splitlines()), strict=True))


def ours(names: Names, entries: Mapping[str, Any], name: str, distro: Distro) -> list[Any]:
    """Return what we say of a name: installer and packages."""
    way = names.installer(name, distro)
    if way != NOT_THERE:
        return [way, list(packages(entries.get(name), CODENAMES[distro.ubuntu]))]
    if distro.name in names.packages.get(name, ()):
        return ["apt", [f"ros-{distro.name}-{name}".replace("_", "-")]]
    return [None, ""]


def compare(names: Names, entries: Mapping[str, Mapping[str, Any]], truth: Mapping[str, Verdicts], show: int) -> int:
    """Print the figures; return how many verdicts differ."""
    wrong = 0
    for distro in DISTROS:
        counts, differ = Counter[str](), []
        for name, (way, told) in truth[distro.name].items():
            mine = ours(names, entries[CODENAMES[distro.ubuntu]], name, distro)
            counts[way or "not resolved"] += 1
            if mine[0] != way or (way and mine[1] != told):
                differ.append((name, (way, told), mine))
        wrong += len(differ)
        said = ", ".join(f"{count} {way}" for way, count in sorted(counts.items()))
        print(f"  {distro.name:<8} {sum(counts.values())} names ({said}): {len(differ)} differ")
        for each in differ[:show]:
            print("    ", *each)
    return wrong


def milliseconds(call: Callable[[str], object], text: str) -> float:
    """Return how long it takes to do something with a text, the best of ten."""
    took = []
    for _ in range(10):
        parse.cache_clear()
        start = time.perf_counter()
        call(text)
        took.append(time.perf_counter() - start)
    return min(took) * 1000


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--source", type=Path, required=True)
    parser.add_argument("--python", default=sys.executable)
    parser.add_argument("--show", type=int, default=10, metavar="N", help="Print so many of those that differ.")
    arguments = parser.parse_args()
    source = arguments.source.resolve()
    place, nothing = index_url(str(source), {}, ""), {"ROSDEP_SOURCE_PATH": ""}
    index = make_index(place, [each.name for each in DISTROS], nothing)
    text = dump(index)
    lists = [(each.codenames, document(each.place)) for each in rosdep_lists(place, nothing)]
    entries = {code: merged(found for codes, found in lists if code in codes) for code in CODENAMES.values()}
    every = sorted({*index.keys, *index.packages, *NOBODYS})
    with tempfile.TemporaryDirectory() as scratch:
        environment = prepare(source, Path(scratch))
        update = [arguments.python, "-c", UPDATE]
        subprocess.run(update, env=environment, check=True, capture_output=True)
        truth = {each.name: rosdep(arguments.python, environment, each, every) for each in DISTROS}
        command = [arguments.python, str(HERE / "rosdistro_verdicts.py"), environment["ROSDISTRO_INDEX_URL"]]
        done = subprocess.run([*command, *index.distros], env=environment, capture_output=True, text=True, check=True)
    print(
        f"index of {source}: {len(text)} bytes, checked at each start in {milliseconds(check, text):.2f} ms, "
        f"read when the first name is asked for in {milliseconds(parse, text):.2f} ms"
    )
    print("what we keep against rosdep:")
    wrong = compare(FetchedNames(text), entries, truth, arguments.show)
    print("what is built in against rosdep:")
    wrong += compare(BUILT_IN, entries, truth, arguments.show)
    print("packages against rosdistro:")
    for name, released in json.loads(done.stdout).items():
        mine = {package for package, distros in index.packages.items() if name in distros}
        wrong += len(mine.symmetric_difference(released))
        print(f"  {name:<8} {len(released)} packages: {len(mine.symmetric_difference(released))} differ")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
