"""Write the table of the names of rclpy (rclpy_names.txt in ros/tables).

    python -m bench.rclpy_names FOLDER

FOLDER holds a bare mirror of ros2/rclpy, `ros2+rclpy/repo`.  The branches of all distributions from Foxy on are read.
"""

from __future__ import annotations

import ast
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

from bench.tables import Origin, Revision, write

BRANCHES = ("foxy", "galactic", "humble", "iron", "jazzy", "kilted", "lyrical", "rolling", "master")
TABLE = "rclpy_names.txt"
ABOUT = {
    TABLE: "The names of the module rclpy, and of the members of its nodes, in any distribution from Foxy on; behind "
    "`submodules` those that exist once something imports them."
}
ORIGIN = Origin("https://github.com/ros2/rclpy, its branches", "Apache-2.0", "bench/rclpy_names.py")
CLASSES = {"Node": "rclpy/rclpy/node.py", "LifecycleNodeMixin": "rclpy/rclpy/lifecycle/node.py"}


def main(folder: Path) -> None:
    git = ["git", "-C", str(folder / "ros2+rclpy" / "repo")]
    found: dict[str, set[str]] = {}
    for branch in BRANCHES:
        listed = run([*git, "ls-tree", "--name-only", branch, "rclpy/rclpy/"]).split()
        stems = {Path(path).stem for path in listed if path.endswith(".py") or not Path(path).suffix}
        found.setdefault("submodules", set()).update(stems - {"__init__"})
        if text := run([*git, "show", f"{branch}:rclpy/rclpy/__init__.py"]):
            found.setdefault("rclpy", set()).update(names_of_module(ast.parse(text)))
        for name, path in CLASSES.items():
            if text := run([*git, "show", f"{branch}:{path}"]):
                found.setdefault(name, set()).update(members(ast.parse(text), name))
    newest = run([*git, "log", "-1", "--format=%H %cs", BRANCHES[-1]]).split()
    rows = [" ".join([name, *sorted(found[name])]) for name in ("rclpy", "submodules", *CLASSES)]
    write(TABLE, ABOUT[TABLE], rows, ORIGIN, Revision(*newest))


def run(command: list[str]) -> str:
    """Return what a command prints, nothing where it fails: a branch may not be there."""
    return subprocess.run(command, capture_output=True, text=True, check=False).stdout


def names_of_module(tree: ast.Module) -> Iterator[str]:
    for node in ast.walk(tree):
        if isinstance(node, (ast.Import, ast.ImportFrom)):
            yield from (each.asname or each.name.partition(".")[0] for each in node.names)
    for each in tree.body:
        if isinstance(each, (ast.FunctionDef, ast.ClassDef)):
            yield each.name


def members(tree: ast.Module, name: str) -> Iterator[str]:
    for owner in (each for each in ast.walk(tree) if isinstance(each, ast.ClassDef) and each.name == name):
        for node in ast.walk(owner):
            if isinstance(node, ast.FunctionDef):
                yield node.name
            if isinstance(node, ast.Attribute) and ast.unparse(node.value) == "self":
                yield node.attr.removeprefix("__")
        yield from (t.id for e in owner.body if isinstance(e, ast.Assign) for t in e.targets if isinstance(t, ast.Name))


if __name__ == "__main__":
    main(Path(sys.argv[1]))
