"""The packages that the files of a package use by their names, declared or not."""

from __future__ import annotations

from collections.abc import Iterator

from ..files import ReaderInput
from ..lazy_regex import regex
from .file_role import role_of
from .launch.launch_file import LaunchFile
from .launch.text import LaunchText, uncommented

SEEKS = {"find-pkg-share": 0, "find-pkg-prefix": 0, "exec-in-pkg": 1}
"""Substitutions that look for a package, and which of their arguments names it."""
IN_ROBOTS = regex(r"\$\(find\s+([\w-]+)\s*\)|\bpackage://([\w-]+)/")
IN_CODE = regex(r"\bget_package_(?:share_(?:directory|path)|prefix)\(\s*[\"']([\w-]+)[\"']")
MARKED = {
    (".xacro", ".urdf", ".sdf"): ((b"$(find", b"package://"), IN_ROBOTS),
    (".py", ".cpp", ".cc", ".hpp", ".h"): ((b"get_package_",), IN_CODE),
}
"""By the endings of their files, what stands in each text that names a package, and how it does."""


def used_packages(reading: ReaderInput) -> frozenset[tuple[str, str]]:
    """Return each package of which something is started or looked for, with the file that does it; not for tests."""
    return frozenset((*of_launch_files(reading), *of_texts(reading)))


def of_launch_files(reading: ReaderInput) -> Iterator[tuple[str, str]]:
    for file in reading.parts(LaunchFile).good:
        for text in named_in(file) if not file.is_ros1 and role_of(file.path) != "test" else ():
            if text.literal and not file.is_guarded(text.literal, text.span):
                yield text.literal, file.path


def named_in(file: LaunchFile) -> Iterator[LaunchText]:
    """Yield what names the packages of nodes and components, and those that substitutions look for."""
    yield from (node.package for node in file.nodes if node.package is not None)
    for each in file.substitutions:
        place = SEEKS.get(each.name)
        if place is not None and len(each.arguments) > place:
            yield each.arguments[place]


def of_texts(reading: ReaderInput) -> Iterator[tuple[str, str]]:
    """Yield what robots and code name."""
    files = reading.files
    for path in files.paths:
        kind = next((kind for endings, kind in MARKED.items() if path.endswith(endings)), None)
        if kind is not None and role_of(path) == "run" and any(files.holds(path, mark) for mark in kind[0]):
            for found in kind[1].finditer(uncommented(path, files.readable_text(path))):
                yield next(filter(None, found.groups())), path
