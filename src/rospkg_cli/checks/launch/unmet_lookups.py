"""Places of a launch file that no launch reaches, as it ends before at a package that nothing brings."""

from __future__ import annotations

from collections.abc import Iterator

from ...package.launch.entity import Entity
from ...package.launch.entity_events import LATER
from ...package.launch.launch_file import LaunchFile
from ...package.launch.text import Substitution
from ...package.workspace import Workspace
from ...source import Span
from .package_reference import FILES_OF, NAME
from .package_references import package_references
from .unmet_lookup import UnmetLookup, is_brought_by_nothing, is_met

ALONE = frozenset({"node", "include", "executable", "node_container", "arg", "let"})
"""Entities that launch visits as a whole."""


class UnmetLookups:
    """Those of the launch files that were asked for."""

    def __init__(self) -> None:
        self.found: dict[int, tuple[LaunchFile, tuple[UnmetLookup, ...]]] = {}
        """By the identity of the file, which is kept with them."""

    def of(self, file: LaunchFile, workspace: Workspace) -> tuple[UnmetLookup, ...]:
        if id(file) not in self.found:
            self.found[id(file)] = file, tuple(unmet_lookups(file, workspace))
        return self.found[id(file)][1]


def package_lacked(file: LaunchFile, span: Span, workspace: Workspace) -> str:
    """Return the missing package at which a launch ends before it reaches a place; "" for none."""
    found = workspace.index_of(UnmetLookups).of(file, workspace)
    return next((each.package for each in found if any(one.contains(span) for one in each.hidden)), "")


def package_lacked_above(file: LaunchFile, span: Span, workspace: Workspace) -> str:
    """Return the same of a line at which Python itself stops: only where Python raises above it counts."""
    found = (each for each in workspace.index_of(UnmetLookups).of(file, workspace) if each.is_early)
    above = (each for each in found if each.span.end <= span.start)
    return next((each.package for each in above if any(one.contains(span) for one in each.hidden)), "")


def unmet_lookups(file: LaunchFile, workspace: Workspace) -> Iterator[UnmetLookup]:
    names = dict.fromkeys(each.arguments[0].literal for each in file.substitutions if is_search(each))
    lacked = {name for name in names if name and NAME.fullmatch(name) and is_brought_by_nothing(name, workspace)}
    if lacked and file.evaluated is not None and file.has_entry_point:
        from .unmet_in_python import unmet_in_python  # few launch files need it

        yield from unmet_in_python(file, file.evaluated, lacked)
    elif lacked and file.root is not None:
        yield from unmet_in_entities(file, file.root, lacked)


def is_search(each: Substitution) -> bool:
    """Return whether a substitution looks for a package; a program of one is looked for as a node's."""
    return each.name in ("find-pkg-share", "find-pkg-prefix") and bool(each.arguments)


def unmet_in_entities(file: LaunchFile, root: Entity, lacked: set[str]) -> Iterator[UnmetLookup]:
    """Yield the first place of a file in XML or YAML that every launch reaches: it hides its entity, and all below."""
    timers = [each.span for each in root.walk() if each.name in LATER]
    for use in package_references(file):
        is_now = use.does == FILES_OF and not any(each.contains(use.span) for each in timers)
        if use.name in lacked and is_now and is_met(file, use.span):
            around = [each.span for each in root.walk() if each.name in ALONE and each.span.contains(use.span)]
            yield UnmetLookup(use.name, use.span, (Span(use.span.start, len(file.source.text)), *around))
            return
