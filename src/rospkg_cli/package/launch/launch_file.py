"""A launch file as rules see it."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import Literal

from ...languages.python.file import PythonFile
from ...languages.python.imports import Import
from ...languages.syntax_problem import SyntaxProblem
from ...light_dataclasses import dataclass
from ...source import Source, Span
from .asked_packages import asked_in
from .configuration_events import LaunchEvent
from .entity import Entity
from .evaluated_launch import EvaluatedLaunch
from .exception_guards import guarded_in
from .file_references import FileReference
from .launched_parts import Command, DeclaredArgument, Include, LaunchedNode
from .text import LaunchText, Substitution

Frontend = Literal["python", "xml", "yaml"]


@dataclass(frozen=True)
class LaunchFile:
    source: Source
    frontend: Frontend
    nodes: tuple[LaunchedNode, ...] = ()
    includes: tuple[Include, ...] = ()
    arguments: tuple[DeclaredArgument, ...] = ()
    commands: tuple[Command, ...] = ()
    substitutions: tuple[Substitution, ...] = ()
    """Every substitution, also those inside of others."""
    assigned: tuple[LaunchText, ...] = ()
    """Names of launch configurations that the file sets itself."""
    every_path: tuple[FileReference, ...] = ()
    """The files that it names, those included of which a part is not known."""
    caught_paths: tuple[FileReference, ...] = ()
    """Files that Python opens where it goes on with nothing if one is missing."""
    is_complete: bool = True
    """False where parts of the file could not be evaluated: there may be more of everything."""
    is_ros1: bool = False
    """Whether it is written for ROS 1."""
    has_entry_point: bool = True
    """Whether launch can start it: in Python, it has `generate_launch_description`."""
    events: tuple[LaunchEvent, ...] | None = None
    """What happens to launch configurations, in order; None where that is unknown."""
    evaluated: EvaluatedLaunch | None = None
    """Of a Python file: every call that it makes. What a check needs to know besides the fields above comes from it."""
    root: Entity | None = None
    """Of an XML or YAML file: its entities, for the same purpose."""
    syntax_problems: tuple[SyntaxProblem, ...] = ()
    """Of an XML or YAML file: text that the frontend can't parse."""

    @property
    def path(self) -> str:
        return self.source.path

    @property
    def python(self) -> PythonFile | None:
        """The file itself, where it is Python."""
        return self.evaluated.file if self.evaluated else None

    @property
    def imports(self) -> tuple[Import, ...]:
        return self.python.imports if self.python else ()

    @cached_property
    def guarded(self) -> tuple[Span, ...]:
        """Where a Python file catches that a package is missing."""
        return tuple(guarded_in(self.python)) if self.python else ()

    @cached_property
    def asked(self) -> tuple[tuple[Span, frozenset[str]], ...]:
        """Where a Python file asks first whether packages are there, and for which."""
        return tuple(asked_in(self.python)) if self.python else ()

    def is_guarded(self, name: str, span: Span) -> bool:
        """Return whether a use of a package at a span is optional: its absence is caught, or asked for first."""
        asked = any(part.holds(span) for part, names in self.asked if name in names)
        return asked or self.catches_missing(span)

    def catches_missing(self, span: Span) -> bool:
        """Return whether the file catches that what is used at a span is missing."""
        return any(guard.holds(span) for guard in self.guarded)

    @property
    def is_fully_known(self) -> bool:
        """Whether all that the file starts is known: nothing in its description is evaluated elsewhere."""
        if not self.is_complete or self.events is None:
            return False
        return all(event.name or event.kind not in ("open", "declare", "define", "include") for event in self.events)

    @cached_property
    def paths(self) -> tuple[FileReference, ...]:
        """The files that it names."""
        return tuple(each for each in self.every_path if not each.is_open)

    @cached_property
    def set_configurations(self) -> frozenset[str]:
        """The launch configurations that anything in the file declares or sets."""
        return frozenset(text.literal for text in (*self.assigned, *(a.name for a in self.arguments)) if text.literal)

    def configurations(self) -> Iterator[Substitution]:
        """Yield the uses of launch configurations: `$(var x)`."""
        return (found for found in self.substitutions if found.name == "var")

    def programs(self) -> Iterator[tuple[str, LaunchText, LaunchedNode]]:
        """Yield package, executable and node of what it starts under literal names, but for ROS 1."""
        for node in self.nodes if not self.is_ros1 else ():
            if node.package and node.executable and node.package.literal and node.executable.literal:
                yield node.package.literal, node.executable, node
