"""Files whose names CMake puts together from the name of the project: `src/${PROJECT_NAME}_node.cpp`."""

from __future__ import annotations

from collections.abc import Iterator

from ..files import PackageFiles
from ..languages.cmake.parser import parse
from ..lazy_regex import regex
from ..source import Source
from ..unreadable import UnreadableError
from .patterns import Affixes

PROJECT = regex(r"\$\{(?:PROJECT_NAME|CMAKE_PROJECT_NAME)\}")
NAMED = regex(r"([\w-]*)\$\{PROJECT_NAME\}([\w-]*)")
START = regex(
    r"^(?:\$\{(?:CMAKE_CURRENT_SOURCE_DIR|CMAKE_SOURCE_DIR|PROJECT_SOURCE_DIR|CMAKE_CURRENT_LIST_DIR)\}/|\./)"
)


def derived_moves(files: PackageFiles, old: str, new: str) -> Iterator[tuple[str, str]]:
    """Yield each file and folder of the package with such a name, and the last part of its new path."""
    for path in files.paths:
        if path.endswith(("CMakeLists.txt", ".cmake")):
            for argument in arguments_of(files, path):
                if PROJECT.search(argument):
                    yield from moves_of(files, path.rpartition("/")[0], START.sub("", argument), old, new)


def project_affixes(files: PackageFiles) -> tuple[Affixes, ...]:
    """Return what stands around the project's name in names that CMake makes of it: ("", "_node")."""
    every = [path for path in files.paths if path.endswith(("CMakeLists.txt", ".cmake"))]
    found = {match.groups() for path in every for text in arguments_of(files, path) if (match := NAMED.fullmatch(text))}
    return tuple(sorted((before, behind) for before, behind in found if before or behind))


def arguments_of(files: PackageFiles, path: str) -> Iterator[str]:
    try:
        source = files.source(path)
    except UnreadableError:
        return
    for command in parse(Source(path, source.text)).commands:
        yield from (each.text for each in command.arguments if each.kind in ("unquoted", "quoted"))


def moves_of(files: PackageFiles, folder: str, argument: str, old: str, new: str) -> Iterator[tuple[str, str]]:
    whole = f"{folder}/{PROJECT.sub(old, argument)}".strip("/")
    if not (files.exists(whole) or whole in files.folders):
        return
    head = folder
    for part in argument.strip("/").split("/"):
        head = f"{head}/{PROJECT.sub(old, part)}".lstrip("/")
        if PROJECT.search(part):
            yield head, PROJECT.sub(new, part)
