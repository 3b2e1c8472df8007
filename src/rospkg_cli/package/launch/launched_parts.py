"""What a launch file starts, includes and declares: nodes, parameters, included files, arguments, commands."""

from __future__ import annotations

from typing import Literal

from ...light_dataclasses import dataclass
from ...source import Span
from .text import LaunchText

NodeKind = Literal["node", "lifecycle_node", "node_container", "composable_node"]


@dataclass(frozen=True)
class NodeParameters:
    """One entry of a node's parameters: a file, or values by name."""

    span: Span
    file: LaunchText | None = None
    values: tuple[tuple[LaunchText, LaunchText], ...] = ()
    is_complete: bool = True
    """False where there may be other values."""


@dataclass(frozen=True)
class LaunchedNode:
    """A process or a component that the file starts."""

    kind: NodeKind
    span: Span
    package: LaunchText | None = None
    executable: LaunchText | None = None
    plugin: LaunchText | None = None
    """The class of a component."""
    name: LaunchText | None = None
    namespace: LaunchText | None = None
    parameters: tuple[NodeParameters, ...] = ()
    remappings: tuple[tuple[LaunchText, LaunchText], ...] = ()
    arguments: tuple[LaunchText, ...] = ()
    is_certain: bool = True
    """False under an unknown condition."""
    is_complete: bool = True
    """False where other arguments may be passed."""


@dataclass(frozen=True)
class Include:
    span: Span
    file: LaunchText
    arguments: tuple[tuple[LaunchText, LaunchText], ...] = ()
    is_certain: bool = True
    is_complete: bool = True
    """False where other arguments may be passed."""


@dataclass(frozen=True)
class DeclaredArgument:
    span: Span
    name: LaunchText
    default: LaunchText | None = None
    choices: tuple[str, ...] = ()
    is_certain: bool = True


@dataclass(frozen=True)
class Command:
    """A command that the file runs: a process of its own, or one whose output it takes."""

    span: Span
    words: tuple[LaunchText, ...]
