"""Packages that a package's CMake finds for itself alone: no target passes them on."""

from __future__ import annotations

from ...files import ReaderInput
from ...languages.cmake.values import UNKNOWN
from ...lazy_regex import regex
from .cmake_project import CMake
from .foreign_commands import foreign_commands
from .target_links import TargetLink, TargetLinks

NAMED = regex(r"\$\{([\w.+-]+?)_(?:TARGETS|LIBRARIES|LIBS|INCLUDE_DIRS?)\}")
MACROS = ("generate_parameter_library", "ament_auto_package", "autoware_ament_auto_package", "ament_vendor")
"""Commands that export packages by themselves."""


def kept_links(reading: ReaderInput) -> frozenset[str]:
    """Return the packages that CMake finds and does not export; nothing where any of that is unknown."""
    cmake = reading.parts(CMake).only
    if cmake is None or not cmake.is_complete or cmake.reads_unknown_files or not cmake.ends_a_package:
        return frozenset()
    extras = any("CONFIG_EXTRAS" in text for call in cmake.calls for text in call.texts)
    if extras or cmake.named(*MACROS) or next(foreign_commands(cmake), None) is not None:
        return frozenset()
    passed = passed_on(cmake)
    return frozenset() if UNKNOWN in passed else frozenset(each.name for each in cmake.packages) - passed


def passed_on(cmake: CMake) -> set[str]:
    """Return the packages that exports, public links and folders name; UNKNOWN among them for any."""
    found: set[str] = set()
    for link in TargetLinks(cmake).all:
        target = cmake.target(link.target)
        if link.is_public and target is not None and target.is_library and not target.call.testing:
            found.add(package_of(link, cmake))
    has_targets = bool(cmake.exports) or any(rule.kind == "EXPORT" for rule in cmake.installs)
    folders = ("target_include_directories", "target_sources") if has_targets else ()
    for call in cmake.calls:
        if call.name.startswith("ament_export_") or call.name in folders:
            for word in call.words:
                named = NAMED.findall(cmake.source_text(word))
                found.update(named if UNKNOWN in word.text and named else [word.text])
    found.update(word.text for target in cmake.interface_targets for word in target.dependencies)
    return found


def package_of(link: TargetLink, cmake: CMake) -> str:
    """Return the package of an argument of a link, "" for a library that CMake looks for by its path.

    A target of the package itself stands for itself.
    """
    written = cmake.source_text(link.word).strip('"')
    if named := NAMED.fullmatch(written):
        return str(named[1])
    if any(written == f"${{{call.texts[0]}}}" for call in cmake.named("find_library") if call.texts):
        return ""
    return UNKNOWN if UNKNOWN in link.word.text else link.word.text.partition("::")[0]
