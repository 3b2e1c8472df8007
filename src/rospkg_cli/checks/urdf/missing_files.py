"""Rule input: a robot description with the files that it refers to, in its package and in other packages."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Literal

from ...files import PackageFiles
from ...package.package_facts import PackageFacts
from ...package.urdf.robot_file import ResourceReference, RobotFile
from ...package.workspace import Workspace
from ...source import Span
from ...suggest import nearest
from ..closest_path import closest_path

State = Literal["absent", "not installed"]


@dataclass(frozen=True, slots=True)
class MissingResource:
    """A file that is referenced and does not exist at run time."""

    span: Span
    package: str
    path: str
    state: State
    is_include: bool
    suggestion: str | None = None
    other_spans: tuple[Span, ...] = ()
    """Other places that refer to it."""


@dataclass(frozen=True)
class RobotInWorkspace:
    robot: RobotFile
    files: PackageFiles
    package: PackageFacts
    workspace: Workspace

    def missing(self) -> Iterator[MissingResource]:
        """Yield each file that is referenced and does not exist, once, as far as that is known."""
        found: dict[tuple[str, str], list[MissingResource]] = {}
        for each in self.every_missing():
            found.setdefault((each.package, each.path), []).append(each)
        for first, *others in found.values():
            yield replace(first, other_spans=tuple(other.span for other in others))

    def every_missing(self) -> Iterator[MissingResource]:
        for reference in self.robot.references:
            facts = self.facts_of(reference)
            if facts is not None and reference.path and not reference.path.startswith(".."):
                state = self.state(facts, reference.path)
                suggestion = self.suggestion(facts, reference.path)
                if state is not None and (facts.knows("share_files") or suggestion):
                    include = reference.use == "include"
                    yield MissingResource(reference.path_span, facts.name, reference.path, state, include, suggestion)
        for local in self.robot.includes:
            if not self.files.exists(local.path) and not local.path.startswith(".."):
                near = nearest(posixpath.basename(local.path), self.neighbours(local.path))
                yield MissingResource(local.span, self.package.name, local.path, "absent", True, near)

    def facts_of(self, reference: ResourceReference) -> PackageFacts | None:
        own = reference.package == self.package.name
        return self.package if own else self.workspace.named(reference.package)

    def state(self, facts: PackageFacts, path: str) -> State | None:
        if path in facts.share_files or path in self.share_folders(facts):
            return None
        if facts is not self.package or not (self.files.exists(path) or path in self.files.folders):
            return "absent"
        top = path.partition("/")[0]
        partly = "/" not in path or top in self.share_folders(facts)
        return "not installed" if partly and facts.knows("share_files") else None

    def share_folders(self, facts: PackageFacts) -> frozenset[str]:
        return self._own_folders if facts is self.package else folders_of(facts.share_files)

    @cached_property
    def _own_folders(self) -> frozenset[str]:
        return folders_of(self.package.share_files)

    def suggestion(self, facts: PackageFacts, path: str) -> str | None:
        known = set(facts.share_files) | (set(self.files.paths) if facts is self.package else set())
        return closest_path(path, known)

    def neighbours(self, path: str) -> list[str]:
        folder = posixpath.dirname(path)
        return [posixpath.basename(each) for each in self.files.paths if posixpath.dirname(each) == folder]


def folders_of(paths: frozenset[str]) -> frozenset[str]:
    found = set()
    for path in paths:
        while path := posixpath.dirname(path):
            found.add(path)
    return frozenset(found)
