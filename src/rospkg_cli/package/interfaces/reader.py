"""Find and read the interface files of a package."""

from __future__ import annotations

from collections.abc import Iterator

from ...files import PackageFiles, ReaderInput, read_each
from ...read_problem import ReadProblem
from ...ros.distros import Targets
from ...ros.interfaces import KINDS
from ...source import Source, Span
from ...unreadable import Unreadable, UnreadableError
from ..file_role import role_of
from ..manifest import Manifest
from .grammar_problem import GrammarCode, GrammarProblem
from .interface_file import InterfaceFile

MAX_LENGTH = 200_000
"""In characters; a message that people write has a hundredth of that."""


def read_interfaces(reading: ReaderInput) -> Iterator[InterfaceFile | Unreadable]:
    """Read the .msg, .srv and .action files of a package that ROS 2 builds."""
    manifest = reading.parts(Manifest).only
    if manifest is None or manifest.build_type(Targets()) == "catkin":
        return
    yield from read_each(reading.files, interface_paths(reading.files), lambda source: read(reading.files, source))


def interface_paths(files: PackageFiles) -> list[str]:
    return [
        path
        for path in files.paths
        if path.endswith(tuple(f".{kind}" for kind in KINDS)) and role_of(path) not in ("test", "aside")
    ]


def read(files: PackageFiles, source: Source) -> InterfaceFile:
    if len(source.text) > MAX_LENGTH:
        raise UnreadableError(source.path, Span(0, 0), ReadProblem.INTERFACE_LENGTH, f"{MAX_LENGTH:,}", skipped=True)
    from .text import parse_interface

    found = parse_interface(source, source.path.rpartition(".")[2])
    if not files.tree.entry(source.path).text.bom:
        return found
    mark = GrammarProblem(Span(0, 0), GrammarCode.BYTE_ORDER_MARK)
    return InterfaceFile(source, found.kind, found.sections, (mark, *found.problems))
