"""Which CMake files of a package are read: CMakeLists.txt, and what it adds and includes."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator
from dataclasses import dataclass

from ...ros.distros import Targets
from ...source import Source
from ..files import PackageFiles, Reading
from ..manifest import Manifest
from ..unreadable import Unreadable, UnreadableError
from .blocks import Block, nest
from .syntax import Command, Fault, Syntax, parse

ROOT = "CMakeLists.txt"
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


def read_cmake_files(reading: Reading) -> Iterator[CMakeFile | Unreadable]:
    """Yield CMakeLists.txt and the package's own files that it reaches by literal paths."""
    if not reading.files.exists(ROOT) or not builds_with_cmake(reading):
        return
    waiting, seen = [ROOT], set()
    while waiting:
        path = waiting.pop()
        if path in seen or not reading.files.exists(path):
            continue
        seen.add(path)
        try:
            file = read_file(reading.files, path)
        except UnreadableError as error:
            yield error.unreadable
            continue
        yield file
        waiting += [posixpath.normpath(posixpath.join(posixpath.dirname(path), p)) for p in reached(file)]


def builds_with_cmake(reading: Reading) -> bool:
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


def reached(file: CMakeFile) -> Iterator[str]:
    for command in file.syntax.commands:
        first = command.arguments[0].text if command.arguments else ""
        if command.name == "add_subdirectory":
            yield posixpath.join(first, ROOT)
        elif command.name == "include":
            yield first
