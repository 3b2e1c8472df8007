"""The places of a file of Python code at which findings say that the run ends."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from ...checks.depends.wrong_rclpy_calls import FOR_OLDER
from ...finding import ALSO, Finding, Location, Severity
from ...languages.python.file import PythonFile
from ...languages.python.nodes import nodes_of_kind
from ...languages.python.unread_types import all_annotations
from ...light_dataclasses import dataclass
from ...package.package_facts import PackageFacts
from ...source import Span
from .finding_builder import AT_RUN

OF_IMPORTS = frozenset({"DEP109", "DEP110", "IDL011"})
UNGENERATED = "IDL008"


@dataclass(frozen=True)
class StoppingPlaces:
    facts: PackageFacts

    def of(self, each: Finding, path: str, file: PythonFile) -> Iterator[Location]:
        """Yield the places of a file at which a finding says that the run ends."""
        if each.code == UNGENERATED and each.severity is Severity.ERROR:
            yield from self.of_ungenerated(path, file)
        elif each.code in AT_RUN:
            is_certain = each.severity is Severity.ERROR
            yield from (at for at in all_places(each, path) if is_certain or not may_pass(file, at.span))
        elif each.code in OF_IMPORTS:
            yield from all_places(each, path)

    def of_ungenerated(self, path: str, file: PythonFile) -> Iterator[Location]:
        """Yield the imports of interfaces that nothing generates."""
        for each in file.imports:
            kind = each.module.removeprefix(f"{self.facts.name}.")
            if kind in ("msg", "srv", "action") and kind != each.module and not each.is_optional:
                yield location(path, file, each.span)


def location(path: str, file: PythonFile, span: Span) -> Location:
    start, end = (file.source.position(at) for at in (span.start, span.end))
    return Location(path, span, *start, *end)


def is_mild_stop(each: Finding) -> bool:
    """Return whether an info is on a place that seldom runs, but ends the run when it does."""
    return each.severity is Severity.INFO and each.code in AT_RUN and not each.message.endswith(FOR_OLDER)


def all_places(each: Finding, path: str) -> list[Location]:
    """Return the places of a finding in one file."""
    also = [at for at, what in each.related if what in ALSO]
    return [at for at in (each.location, *also) if at.path == path]


def may_pass(file: PythonFile, span: Span) -> bool:
    """Return whether a place is no error in some version of Python or distribution: a keyword or an annotation."""
    keywords = any(file.span(each).holds(span) for each in nodes_of_kind(file.tree, ast.keyword))
    return keywords or any(file.span(each).holds(span) for each in all_annotations(file))
