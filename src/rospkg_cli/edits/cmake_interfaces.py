"""Edits of rosidl_generate_interfaces(): interface files and the packages that they depend on."""

from __future__ import annotations

import posixpath
from collections.abc import Sequence

from ..checks.interfaces.rosidl_dependencies import UnlistedDependency
from ..checks.interfaces.rosidl_targets import RosidlTargets
from ..finding import Edit
from ..languages.cmake.values import Word
from ..package.cmake.cmake_project import CMake
from ..package.interfaces.interface_file import InterfaceFile
from ..ros.interfaces import valid_interface_name
from ..source import Span
from .cmake_commands import add_argument


def add_interface_file(generated: RosidlTargets, interface: InterfaceFile) -> Edit | None:
    """Add an interface file among those of its kind, sorted where they are; None where none is listed.

    None also for a name that rosidl refuses: the build would end there.
    """
    if not valid_interface_name(posixpath.basename(interface.path).removesuffix(f".{interface.kind}")):
        return None
    suffix = f".{interface.kind}"
    of_kind = [each for each in generated.listed if each.word.text.endswith(suffix)]
    like = of_kind or list(generated.listed)
    written = [each.word for each in like if is_written(generated.cmake, each.word)]
    if not written:
        return None
    folder = like[0].target.call.folder
    path = posixpath.relpath(interface.path, folder or ".")
    return insert_word(generated.cmake, written, path, sort=bool(of_kind))


def add_interface_dependency(generated: RosidlTargets, need: UnlistedDependency) -> Edit | None:
    """Put a package among the DEPENDENCIES of a call; None where these are not written out in it."""
    cmake, command = generated.cmake, need.target.call.command
    written = [word for word in need.target.dependencies if is_written(cmake, word)]
    if written:
        return insert_word(cmake, written, need.package, sort=True)
    if need.target.dependencies or not command.arguments:
        return None
    file = cmake.file(need.target.call.path)
    last = command.arguments[-1].span
    line = file.source.line_span(file.source.position(last.start)[0])
    if file.source.text[line.start : last.start].strip():
        return Edit(file.path, Span(last.end, last.end), f"\n{file.indent}DEPENDENCIES {need.package}")
    return add_argument(file, command, f"DEPENDENCIES {need.package}")


def is_written(cmake: CMake, word: Word) -> bool:
    """Return whether a file holds a word literally."""
    text = cmake.file(word.path).source.slice(word.span)
    return text.strip('"') == word.text


def insert_word(cmake: CMake, words: Sequence[Word], text: str, *, sort: bool) -> Edit:
    """Put a text between words: behind the last that is smaller where they are sorted, else behind all of them."""
    file = cmake.file(words[0].path)
    words = [word for word in words if word.path == file.path]
    quote = '"' if file.source.text[words[0].span.start] == '"' else ""
    written = f"{quote}{text}{quote}"
    texts = [word.text for word in words]
    smaller = [word for word in words if word.text < text] if sort and texts == sorted(texts) else list(words)
    if smaller:
        return add_argument(file, cmake.root.syntax.commands[0], written, after=smaller[-1].span)
    first = words[0].span
    line = file.source.line_span(file.source.position(first.start)[0])
    before = file.source.text[line.start : first.start]
    glue = " " if before.strip() else f"\n{before}"
    return Edit(file.path, Span(first.start, first.start), f"{written}{glue}")
