"""One CMake file of a package: parsed, or refused where CMake would refuse it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from ...ros.distros import Targets
from ...source import Source
from ..files import PackageFiles, Reading
from ..manifest import Manifest
from ..unreadable import UnreadableError
from .blocks import Block, nest
from .syntax import Command, Fault, Syntax, parse

ROOT = "CMakeLists.txt"
SETTERS = {"set": 0, "option": 0, "list": 1, "foreach": 0, "get_filename_component": 0, "set_property": 0}
"""Where in their arguments commands name a variable that they set."""

BUILDS_WITHOUT = frozenset({"ament_python"})
"""Build types under which nobody reads a CMakeLists.txt."""


@dataclass(frozen=True)
class CMakeFile:
    """One file that can be read: its commands, flat and in their blocks."""

    syntax: Syntax
    body: list[Command | Block]

    @property
    def source(self) -> Source:
        return self.syntax.source

    @property
    def path(self) -> str:
        return self.syntax.source.path


def is_built_with_cmake(reading: Reading) -> bool:
    """Return whether the build reads a CMakeLists.txt of the package."""
    if not reading.files.exists(ROOT):
        return False
    manifest = reading.parts(Manifest).only
    return manifest is None or manifest.build_type(Targets()) not in BUILDS_WITHOUT


def read_file(files: PackageFiles, path: str) -> CMakeFile:
    """Read one file; raises UnreadableError at the first place that CMake would refuse."""
    syntax = parse(files.source(path))
    body, faults = nest(syntax.commands)
    refuse(path, syntax.faults or tuple(faults))
    return CMakeFile(syntax, body)


def refuse(path: str, faults: tuple[Fault, ...]) -> None:
    if faults:
        first = faults[0]
        raise UnreadableError(path, first.span, f"`{path}` is not valid CMake: {first.message}")


def names_set(file: CMakeFile) -> Iterator[str]:
    """Yield the names of variables that a file sets somewhere by a literal name."""
    for command in file.syntax.commands:
        at = SETTERS.get(command.name)
        if at is not None and len(command.arguments) > at:
            yield command.arguments[at].text
