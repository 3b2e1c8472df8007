"""Which files an install rule copies, and to where: CMake's own rules for folders, patterns and new names."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from ...files import PackageFiles
from ...languages.cmake.evaluated_command import path_in_package
from ...languages.cmake.regex import glob_pattern, search
from ...languages.cmake.values import SOURCE, Word
from ...light_dataclasses import dataclass
from .install_rule import InstallRule, Pattern


@dataclass(frozen=True, slots=True)
class CopiedFile:
    """One file of the package that is copied below the prefix."""

    source: str
    destination: str
    rule: InstallRule
    item: Word

    @property
    def is_executable(self) -> bool:
        """Whether it is executable there, whatever it is here."""
        if self.rule.kind == "PROGRAMS" and not self.rule.permissions:
            return True
        fitting = (each.permissions for each in self.rule.patterns if each.permissions and fits(each, self.source))
        return any(each.endswith("EXECUTE") for each in self.rule.permissions.union(*fitting))

    @property
    def keeps_permissions(self) -> bool:
        return "USE_SOURCE_PERMISSIONS" in self.rule.permissions


def copied_files(rule: InstallRule, files: PackageFiles) -> Iterator[CopiedFile]:
    """Yield what a rule for files, programs or folders copies; nothing for items that are unknown or not there."""
    if rule.destination is None:
        return
    for item in rule.items:
        path = path_in_package(item.text, rule.call.folder)
        if path is None:
            continue
        if rule.kind == "DIRECTORY":
            yield from folder_copies(rule, item, path, files)
        elif rule.kind in ("FILES", "PROGRAMS") and files.is_there(path):
            name = rule.rename.text if rule.rename else posixpath.basename(path)
            yield CopiedFile(path, posixpath.normpath(posixpath.join(rule.destination, name)), rule, item)


def folder_copies(rule: InstallRule, item: Word, folder: str, files: PackageFiles) -> Iterator[CopiedFile]:
    """Yield the files below a folder: `launch` is copied with its own name, of `launch/` only the contents."""
    whole = not item.text or item.text.endswith("/") or not folder
    base = folder if whole else posixpath.dirname(folder)
    excluding = [pattern for pattern in rule.patterns if pattern.is_exclude]
    including = [pattern for pattern in rule.patterns if not pattern.is_exclude]
    for path in files.every if not folder else [p for p in files.every if p.startswith(f"{folder}/")]:
        inside = [p for p in (path, *ancestors(path)) if p == folder or len(p) > len(folder)]
        if any(fits(pattern, each) for pattern in excluding for each in inside):
            continue
        if rule.matching and not any(fits(pattern, path) for pattern in including):
            continue
        place = posixpath.join(rule.destination or ".", posixpath.relpath(path, base or "."))
        yield CopiedFile(path, posixpath.normpath(place), rule, item)


def ancestors(path: str) -> Iterator[str]:
    while "/" in path:
        path = posixpath.dirname(path)
        yield path


def fits(pattern: Pattern, path: str) -> bool:
    """Return whether a pattern fits a file or folder: the last parts of its path, or any piece for REGEX."""
    if pattern.is_regex:
        return search(pattern.text, f"{SOURCE}/{path}") is True
    found = glob_pattern(pattern.text)
    parts = path.split("/")
    last = "/".join(parts[-1 - pattern.text.count("/") :])
    return found is not None and found.match(last) is not None
