"""The packages that the files of a package use by their names, declared or not."""

from __future__ import annotations

from collections.abc import Iterator

from ..files import ReaderInput
from ..languages.python.file import PythonFile
from ..lazy_regex import regex
from .file_role import role_of
from .launch.exception_guards import guarded_in
from .launch.launch_file import LaunchFile
from .launch.text import LaunchText, uncommented
from .python_modules import PythonModules

SEEKS = {"find-pkg-share": 0, "find-pkg-prefix": 0, "exec-in-pkg": 1}
"""Substitutions that look for a package, and which of their arguments names it."""
IN_ROBOTS = regex(r"\$\(find\s+([\w-]+)\s*\)|\bpackage://([\w-]+)/")
IN_CODE = regex(r"\bget_package_(?:share_(?:directory|path)|prefix)\(\s*[\"']([\w-]+)[\"']")
ROBOTS, CODE = (".xacro", ".urdf", ".sdf"), (".cpp", ".cc", ".hpp", ".h")
MARKS = {ROBOTS: (b"$(find", b"package://"), CODE: (b"get_package_",), (".py",): (b"get_package_",)}
"""By the endings of their files, what stands in each text that names a package."""


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
        marks = next((marks for endings, marks in MARKS.items() if path.endswith(endings)), ())
        if marks and role_of(path) == "run" and any(files.holds(path, mark) for mark in marks):
            yield from ((name, path) for name in named_by(reading, path))


def named_by(reading: ReaderInput, path: str) -> Iterator[str]:
    if path.endswith(".py"):
        modules = reading.parts(PythonModules).only
        file = modules.at(path) if modules is not None else None
        yield from looked_up_in(file) if file is not None else ()
        return
    text = uncommented(path, reading.files.readable_text(path))
    for found in (IN_ROBOTS if path.endswith(ROBOTS) else IN_CODE).finditer(text):
        yield next(filter(None, found.groups()))


def looked_up_in(file: PythonFile) -> Iterator[str]:
    """Yield what a module looks for and can't do without."""
    text, caught = file.source.text, [*guarded_in(file)]
    for found in IN_CODE.finditer(text):
        is_comment = "#" in text[text.rfind("\n", 0, found.start()) + 1 : found.start()]
        if not is_comment and not any(each.start <= found.start() < each.end for each in caught):
            yield found[1]
