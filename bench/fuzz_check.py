"""What is wrong with a package that `new` has written, as its linter and the readers of each format see it."""

from __future__ import annotations

import ast
import configparser
import warnings
from collections.abc import Callable, Iterator
from pathlib import Path
from xml.etree import ElementTree

import yaml

from rospkg_cli.disk import DiskTree
from rospkg_cli.engine.discovery.discover import packages_below
from rospkg_cli.engine.run.scope import Scope
from rospkg_cli.engine.run.session import Session
from rospkg_cli.engine.selection import EVERYTHING
from rospkg_cli.ros.distros import Targets
from rospkg_cli.scaffold.answers import Request

ASKED_FOR = frozenset({"DEP001", "IDL003", "LCH004", "XML104"})
"""What `new` tells of what was asked for and writes nevertheless: keys and nodes that nobody knows, words of IDL,
a description that is none."""


def problems(folder: Path, asked: Request) -> Iterator[str]:
    """Yield what is wrong with a package on disk."""
    for path in sorted(folder.rglob("*")):
        if path.is_file():
            yield from unreadable(path)
    yield from changed(folder, asked)
    yield from findings(folder, asked.distro)


def unreadable(path: Path) -> Iterator[str]:
    data = path.read_bytes()
    for ends, reader in READERS.items():
        if path.name.endswith(ends):
            try:
                with warnings.catch_warnings():
                    warnings.simplefilter("error")
                    reader(data)
            except Exception as error:
                yield f"{path.name}: {type(error).__name__}: {error}"
    if b"\r" in data or b"\0" in data or b"\x1b" in data:
        yield f"{path.name}: a control character"


def python(data: bytes) -> None:
    ast.parse(data)
    compile(data, "written.py", "exec", dont_inherit=True)


READERS: dict[str, Callable[[bytes], object]] = {
    ".py": python,
    ".xml": ElementTree.fromstring,
    ".xacro": ElementTree.fromstring,
    ".urdf": ElementTree.fromstring,
    ".yaml": yaml.safe_load,
    ".yml": yaml.safe_load,
    ".rviz": yaml.safe_load,
    ".cfg": lambda data: configparser.ConfigParser().read_string(data.decode()),
}


def changed(folder: Path, asked: Request) -> Iterator[str]:
    """Yield the texts that came back in other words from package.xml."""
    root = ElementTree.parse(folder / "package.xml").getroot()
    for tag, text in (("description", asked.description), ("maintainer", asked.maintainer)):
        found = root.findtext(tag) or ""
        if text.split() and " ".join(text.split()) != " ".join(found.split()):
            yield f"<{tag}> holds {found!r}"


def findings(folder: Path, distro: str) -> Iterator[str]:
    tree = DiskTree(folder.parent)
    if list(packages_below(folder.parent)) != [folder]:
        yield "it is not found as a package"
    session = Session(tree, Scope((folder.name,), frozenset({folder.name})), EVERYTHING.codes(), Targets((distro,)))
    for each in session.run().findings:
        if each.code not in ASKED_FOR:
            yield f"{each.location.path}:{each.location.line}: {each.code} {each.message}"
