"""Headers that nothing here compiles, and whether a header declares classes that a file uses (CMK201)."""

from __future__ import annotations

from collections.abc import Iterable

from ...languages.cpp.code_text import code_text
from ...languages.cpp.file import CppFile
from ...lazy_regex import regex
from ...package.cmake.cmake_project import CMake
from ...package.workspace import Workspace
from ..depends.header_inclusions import HEADERS
from ..depends.sources_by_use import sources_by_use

DECLARED = regex(r"\b(?:class|struct|enum(?:\s+class)?)\s+(?:[A-Z][A-Z0-9_]*_PUBLIC\s+)?(\w+)\b(?!\s*[;>,&*])")
"""A class that a header does not only name, or a parameter of a template."""
NAME = regex(r"\b[A-Za-z_]\w*\b")


def is_unmet(cmake: CMake, sources: Iterable[CppFile], path: str, workspace: Workspace, package: str) -> bool:
    """Return whether a header is of a package that compiles tests alone, none with it, and is for no other one here."""
    known, _ = sources_by_use(cmake, sources)
    if not known.is_known or known.own or not known.tests or not path.endswith(HEADERS):
        return False
    if path in known.including.reached(known.tests):
        return False
    return not any(each.is_compiled for each in workspace.needing(package))


def may_be_for(source: CppFile, header: CppFile) -> bool:
    """Return whether a file may include a header for what it holds: one of its classes, or it has none."""
    declared = set(DECLARED.findall(code_text(header.source.text)))
    return not declared or not declared.isdisjoint(NAME.findall(code_text(source.source.text)))
