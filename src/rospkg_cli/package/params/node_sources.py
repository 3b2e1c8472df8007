"""Which files of a package's code run behind an executable or a component."""

from __future__ import annotations

from collections.abc import Iterator

from ...files import ReaderInput
from ...languages.cmake.evaluated_command import path_in_package
from ...languages.cmake.targets import Target
from ...languages.cpp.read import SUFFIXES
from ...lazy_regex import regex
from ...unreadable import UnreadableError
from ..cmake.cmake_project import CMake
from .declared_parameter import NodeCode

REGISTERED = regex(r"RCLCPP_COMPONENTS_REGISTER_NODE\s*\(\s*(?:::)?([\w:]+)\s*\)")


def node_code(reading: ReaderInput) -> tuple[NodeCode, ...]:
    """Return, for what CMake builds, the files that certainly run: those of the executable, or of the component."""
    cmake = reading.parts(CMake).only
    if cmake is None:
        return ()
    registered = {name: path for path, name in registrations(reading)}
    found = []
    for component in cmake.components:
        path = registered.get(component.plugin.text)
        if path is not None:
            names = [component.plugin.text, *([component.executable.text] if component.executable else [])]
            found += [NodeCode(name, frozenset({path})) for name in names]
    for target in cmake.targets:
        if target.is_executable and target.word.is_known:
            found.append(NodeCode(target.name, frozenset(sources(cmake, target))))
    return tuple(found)


def registrations(reading: ReaderInput) -> Iterator[tuple[str, str]]:
    """Yield each file that registers a component, with the class."""
    for path in reading.files.paths:
        if path.endswith(SUFFIXES):
            try:
                text = reading.files.source(path).text
            except UnreadableError:
                continue
            if "RCLCPP_COMPONENTS_REGISTER_NODE" in text:
                yield from ((path, match.group(1)) for match in REGISTERED.finditer(text))


def sources(cmake: CMake, target: Target) -> Iterator[str]:
    for word in target.sources:
        path = path_in_package(word.text, target.call.folder)
        if path:
            yield path
    folder = path_in_package(target.folder.text, target.call.folder) if target.folder else None
    if folder is not None:
        yield from (path for path in cmake.package_files.below(folder) if path.endswith(SUFFIXES))
