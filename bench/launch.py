"""Launch files of real checkouts, read: `python -m bench.launch REPOSITORY…`

Counts files, nodes, includes and arguments by frontend, how many texts can't be told, and which elements and
substitutions of XML and YAML files stand in no table of ours, and which calls stand in the text of a Python file and in
no fact.  `--sample N --seed S` prints that many Python files, evenly over the repositories, each with what we make of
it beside its text, to be read by hand: what would launch make of it?
"""

from __future__ import annotations

import argparse
import ast
import random
import time
from collections import Counter
from collections.abc import Iterator
from itertools import islice, zip_longest
from pathlib import Path

from rospkg_cli.disk import DiskTree
from rospkg_cli.engine.discovery.discover import packages_below
from rospkg_cli.files import PackageFiles
from rospkg_cli.package.launch.entity import from_xml, from_yaml
from rospkg_cli.package.launch.launch_file import DeclaredArgument, Include, LaunchedNode, LaunchFile
from rospkg_cli.package.launch.python_actions import NODES
from rospkg_cli.package.launch.text import LaunchText
from rospkg_cli.package.package import Package
from rospkg_cli.report.inspect_launch import launch_lines
from rospkg_cli.ros.launch_entities import ACTIONS, PARTS, SUBSTITUTIONS
from rospkg_cli.source import Span

Found = tuple[Path, LaunchFile]


def launch_files(repository: Path, counts: Counter[str]) -> Iterator[Found]:
    """Yield the launch files of a checkout, each with its package; those that can't be read are counted."""
    for folder in packages_below(repository):
        parts = Package(PackageFiles(DiskTree(folder))).parts(LaunchFile)
        for broken in parts.broken:
            counts["unreadable"] += 1
            print(f"unreadable: {folder / broken.path}: {broken.message}")
        yield from ((folder, file) for file in parts.good)


def texts_of(file: LaunchFile) -> Iterator[LaunchText | None]:
    for node in file.nodes:
        yield from (node.package, node.executable, node.plugin, node.name, node.namespace)
        yield from (given.file for given in node.parameters)
    yield from (include.file for include in file.includes)
    yield from (argument.name for argument in file.arguments)


def count(file: LaunchFile, counts: Counter[str]) -> None:
    kind = f"{file.frontend}{' of ROS 1' if file.ros1 else ''}"
    texts = [text for text in texts_of(file) if text is not None]
    counts[f"{kind}: files"] += 1
    counts[f"{kind}: nodes"] += len(file.nodes)
    counts[f"{kind}: includes"] += len(file.includes)
    counts[f"{kind}: arguments"] += len(file.arguments)
    counts[f"{kind}: texts"] += len(texts)
    counts[f"{kind}: texts of which nothing is known"] += sum(text.unknown for text in texts)
    counts[f"{kind}: files not evaluated to their end"] += not file.complete
    counts[f"{kind}: files whose launch description can't be told"] += file.events is None


MADE = frozenset({*NODES, "IncludeLaunchDescription", "DeclareLaunchArgument"})


def span_of(made: LaunchedNode | Include | DeclaredArgument) -> Span:
    return made.span


def overlooked(file: LaunchFile) -> Iterator[str]:
    """Yield the calls of the classes of launch that stand in a Python file and that we never came to."""
    python = file.python
    if python is None:
        return
    homes = {name for each in python.imports if each.module.startswith("launch") for name in each.names}
    facts = {span for several in (file.nodes, file.includes, file.arguments) for span in map(span_of, several)}
    for node in ast.walk(python.tree):
        if isinstance(node, ast.Call) and python.span(node) not in facts:
            name = node.func.id if isinstance(node.func, ast.Name) else getattr(node.func, "attr", "")
            direct = isinstance(node.func, ast.Name) and name in homes
            dotted = isinstance(node.func, ast.Attribute) and ast.unparse(node.func).startswith(
                ("launch.", "launch_ros.")
            )
            if name in MADE and (direct or dotted):
                yield f"{file.path}:{node.lineno}: {name}"


def strangers(folder: Path, file: LaunchFile) -> Iterator[str]:
    """Yield the elements and substitutions of an XML or YAML file that no table of ours has."""
    root = from_xml(file.source) if file.frontend == "xml" else from_yaml(file.source)[0]
    for entity in root.walk() if root is not None and not file.ros1 else ():
        if entity.name not in ACTIONS and entity.name not in PARTS:
            yield f"element {entity.name}"
    for found in file.substitutions if not file.ros1 else ():
        if found.name not in SUBSTITUTIONS and found.name != "?":
            yield f"substitution {found.name}"


def sample(found: dict[Path, list[Found]], size: int, seed: int) -> list[Found]:
    """Return some Python files, one of each repository in turn."""
    dice = random.Random(seed)
    piles = []
    for repository in sorted(found):
        python = [each for each in found[repository] if each[1].frontend == "python" and each[1].entry]
        piles.append(dice.sample(python, len(python)))
    turns = (each for turn in zip_longest(*piles) for each in turn if each is not None)
    return list(islice(turns, size))


def show(folder: Path, file: LaunchFile) -> None:
    print(f"{'=' * 100}\n{folder / file.path}\n{'-' * 100}")
    print("\n".join(launch_lines(file, False)))
    print(f"{'-' * 100}\n{file.source.text}")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("repositories", nargs="+", type=Path)
    parser.add_argument("--sample", type=int, default=0)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    counts, odd, started = Counter[str](), Counter[str](), time.monotonic()
    found = {repository: list(launch_files(repository, counts)) for repository in arguments.repositories}
    for folder, file in (each for several in found.values() for each in several):
        count(file, counts)
        for each in overlooked(file):
            counts["python: calls that we never came to"] += 1
            print(f"overlooked: {folder / each}")
        if file.frontend != "python":
            odd.update(strangers(folder, file))
    for folder, file in sample(found, arguments.sample, arguments.seed):
        show(folder, file)
    for name, number in sorted(counts.items()):
        print(f"{number:>6} {name}")
    print("in no table:", ", ".join(f"{name} ({number})" for name, number in odd.most_common()) or "nothing")
    print(f"{time.monotonic() - started:.0f} s")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
