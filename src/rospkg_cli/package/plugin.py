"""Plugins that a package describes, and places that name plugins, as other packages know them."""

from __future__ import annotations

from ..light_dataclasses import dataclass
from ..source import Span


@dataclass(frozen=True, slots=True)
class Plugin:
    """A class that a plugin description of the package has."""

    name: str
    """By which it is loaded."""
    type: str
    base: str
    """Its base class."""
    packages: frozenset[str]
    """Those that its description is exported to."""
    path: str
    span: Span = Span(0, 0)
    """Of the name in the description."""


@dataclass(frozen=True, slots=True)
class PluginUse:
    """A place that names a plugin: `package/Class` or `namespace::Class`."""

    name: str
    path: str
    span: Span
    is_listed: bool = True
    """False where nothing loads it: no list of plugins next to it names its block, or other controllers of the file are
    spawned, and this one is not.
    """
    kind: str = ""
    """What RViz loads it as, by the list of its config that it is in: `Panel`, `Display`, `Tool`, `ViewController`."""
    is_plain_type: bool = False
    """Whether its key is `type`, of a node that is no controller manager: it may be a name of anything."""
