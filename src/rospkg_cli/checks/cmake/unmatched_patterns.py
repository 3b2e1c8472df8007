"""Folders that are installed with FILES_MATCHING, and of which no file has the name that is asked for (CMK129)."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator, Sequence

from ...languages.cmake.evaluated_command import path_in_package
from ...languages.cmake.values import UNKNOWN, Word
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_package import CMakePackage
from ...package.cmake.cmake_project import CMake
from ...package.cmake.copied_files import copied_files, folder_copies
from ...package.cmake.install_rule import InstallRule
from ...package.cmake.installed_headers import HEADERS
from ...package.workspace import Workspace
from ...ros.share_layout import LAUNCH
from ..share_uses import ShareUses
from ..uninstalled_folders import UninstalledFolders
from .consumers import Consumers

FAMILIES = tuple(
    frozenset(each.split())
    for each in (
        ".h .hh .hpp .hxx .h++ .inl .ipp .tpp .cuh",
        ".launch .launch.py .launch.xml .launch.yaml .py .xml",
        ".yaml .yml .YAML .json",
        ".stl .STL .dae .DAE .obj .OBJ .mesh .glb",
        ".urdf .xacro .urdf.xacro .sdf .srdf",
        ".png .jpg .jpeg .PNG .JPG .pgm",
    )
)
"""Endings of files that serve the same purpose."""
ENDING = regex(r"\*(\.[\w.+]*\w\+*)")


@dataclass(frozen=True, slots=True)
class UnmatchedPattern:
    item: Word
    rule: InstallRule
    folder: str
    patterns: tuple[str, ...]
    others: tuple[str, ...]
    """The files that are intended, most likely."""
    is_installed: bool
    """Whether another rule installs them all."""
    is_harmless: bool = False
    """Whether another rule takes some of them, or it stands in a function, which others call for other folders."""


@dataclass(frozen=True)
class UnmatchedPatterns:
    """The folders of a package, and whether anything looks for what is not installed of them."""

    package: CMakePackage
    workspace: Workspace
    consumers: Consumers

    def all(self) -> Iterator[UnmatchedPattern]:
        return unmatched_patterns(self.package.cmake)

    def are_wanted(self, found: UnmatchedPattern) -> bool:
        """Return whether a package includes one of the headers, or something opens one of the files.

        Launch files are opened by those who start them.
        """
        if found.others[0].endswith(HEADERS):
            return bool(self.consumers.including)
        uses = ShareUses(self.package.cmake.package_files, self.package.facts.name, self.workspace)
        names = {posixpath.basename(path) for path in found.others}
        is_started = any(LAUNCH.fullmatch(name) for name in names)
        return is_started or UninstalledFolders(uses).level(found.folder) != "info" or any(map(uses.names_file, names))


def unmatched_patterns(cmake: CMake) -> Iterator[UnmatchedPattern]:
    """Yield each folder with files of the same purpose, none of which has the ending that a rule asks for."""
    for rule in cmake.installs:
        texts = tuple(each.text for each in rule.patterns if not each.is_exclude)
        endings = [found[1] for found in map(ENDING.fullmatch, texts) if found is not None]
        if rule.kind != "DIRECTORY" or not rule.matching or rule.call.maybe or not texts or len(endings) < len(texts):
            continue
        family = next((each for each in FAMILIES if each.issuperset(endings)), None)
        for item in rule.items if family is not None else ():
            path = path_in_package(item.text, rule.call.folder) if item.is_known and not item.maybe else None
            if path and UNKNOWN not in path and (found := similar_files(cmake, rule, item, path, sorted(family or ()))):
                others = [each for each in cmake.installs if each is not rule]
                copies = [copy for each in others for copy in copied_files(each, cmake.package_files)]
                there = {copy.source for copy in copies}
                if not any(copy.rule.matching and copy.source in found for copy in copies):
                    harmless = bool(rule.call.function) or any(takes(cmake, each, path, found) for each in others)
                    yield UnmatchedPattern(item, rule, path, texts, tuple(found), there.issuperset(found), harmless)


def takes(cmake: CMake, rule: InstallRule, folder: str, wanted: Sequence[str]) -> bool:
    """Return whether a rule with patterns takes files of a folder to wherever."""
    if rule.kind != "DIRECTORY" or not rule.matching:
        return False
    items = (item for item in rule.items if path_in_package(item.text, rule.call.folder) == folder)
    return any(
        not {c.source for c in folder_copies(rule, i, folder, cmake.package_files)}.isdisjoint(wanted) for i in items
    )


def similar_files(cmake: CMake, rule: InstallRule, item: Word, folder: str, endings: Sequence[str]) -> list[str]:
    """Return the files below a folder of the same purpose as those that a rule asks for; none where it has some.

    Those that the build makes, or that git ignores, are not known.
    """
    files = cmake.package_files
    folder = folder.rstrip("/")
    copied = list(folder_copies(rule, item, folder, files))
    asked = (f"{folder}/a{each.text.removeprefix('*')}" for each in rule.patterns if not each.is_exclude)
    if copied or any(map(files.absent.is_expected, asked)):
        return []
    return [path for path in files.below(folder) if path.endswith(tuple(endings)) and not path.endswith("__init__.py")]
