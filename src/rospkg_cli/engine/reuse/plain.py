"""Facts and findings as plain data, and back: only values of the classes that are listed here are ever made."""

from __future__ import annotations

from enum import Enum
from typing import Any

from ...disk_trace import digest
from ...finding import (
    Chmod,
    Create,
    Delete,
    Edit,
    Finding,
    Fix,
    Location,
    Move,
    Safety,
    Severity,
)
from ...light_dataclasses import field_names
from ...package.interfaces.message_fields import MessageFields
from ...package.launch.configuration_events import ConfigurationSummary
from ...package.launch.launch_signature import LaunchSignature
from ...package.package_facts import ActiveDependency, PackageFacts
from ...package.params.declared_parameter import DeclaredParameter, NodeCode, NodeName
from ...package.plugin import Plugin, PluginUse
from ...source import Span
from ..suppression.comments import Suppression

KINDS: dict[str, type[Any]] = {
    kind.__name__: kind
    for kind in (
        *(PackageFacts, ActiveDependency, Plugin, PluginUse, LaunchSignature, ConfigurationSummary, MessageFields),
        *(DeclaredParameter, NodeCode, NodeName, Span, Suppression),
        *(Finding, Fix, Location, Edit, Create, Delete, Move, Chmod),
    )
}
ENUMS: dict[str, type[Enum]] = {kind.__name__: kind for kind in (Severity, Safety)}

FIELDS = {name: field_names(kind) for name, kind in KINDS.items()}


def to_plain(value: Any) -> Any:
    """Return a value as lists, strings, numbers, booleans and None; raises TypeError for a class that isn't listed."""
    if value is None or isinstance(value, str | int):
        return value
    if isinstance(value, tuple):
        return ["tuple", *map(to_plain, value)]
    if isinstance(value, frozenset):
        return ["frozenset", *sorted(map(to_plain, value), key=repr)]
    name = type(value).__name__
    if ENUMS.get(name) is type(value):
        return [name, value.value]
    if KINDS.get(name) is not type(value):
        raise TypeError(f"{name} can't be kept")
    return [name, *(to_plain(getattr(value, each)) for each in FIELDS[name])]


def from_plain(data: Any) -> Any:
    """Return the value again; raises LookupError, TypeError or ValueError where the data is none of ours."""
    if not isinstance(data, list):
        return data
    name, *parts = data
    if name == "tuple":
        return tuple(map(from_plain, parts))
    if name == "frozenset":
        return frozenset(map(from_plain, parts))
    if name in ENUMS:
        return ENUMS[name](*parts)
    if len(parts) != len(FIELDS[name]):
        raise ValueError(f"{name} has other fields")
    return KINDS[name](*map(from_plain, parts))


def digest_of(value: Any) -> str:
    """Return a digest of a value; equal values have the same."""
    import json

    return digest(json.dumps(to_plain(value)).encode())
