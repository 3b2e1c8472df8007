"""Build the inputs that rules ask for by type: the model of one file, or a frozen dataclass of inputs."""

from __future__ import annotations

import itertools
import types
import typing
from collections.abc import Iterator
from functools import cache
from typing import Any, NamedTuple

from ...files import PackageFiles
from ...light_dataclasses import field_names
from ...package.package import Package
from ...package.package_facts import PackageFacts
from ...package.readers import READERS
from ...package.rule_settings import RuleSettings
from ...package.workspace import Workspace
from ...ros.distros import Targets
from ...unreadable import READABLE, Unreadable


class InputPart(NamedTuple):
    kind: type
    is_optional: bool = False
    """Whether it may be absent."""
    is_every: bool = False
    """Whether it is a tuple of all of them."""
    is_readable: bool = False
    """Whether such a tuple does without those that can't be read."""


class InputBuilder:
    """Builds the inputs of one package, those of each type once."""

    def __init__(self, package: Package, workspace: Workspace, targets: Targets, settings: RuleSettings) -> None:
        self.package = package
        self.provided: dict[type, Any] = {
            PackageFiles: package.files,
            Workspace: workspace,
            Targets: targets,
            RuleSettings: settings,
            PackageFacts: workspace.at(package.folder),
        }
        self.built: dict[type, list[Any]] = {Unreadable: []}

    def of(self, kind: type) -> list[Any]:
        """Return the inputs of a type; none where a part of it is absent or broken."""
        if kind in self.provided:
            return [self.provided[kind]]
        if kind is Unreadable:
            return self.package.unreadable()
        if kind in READERS:
            return list(self.package.parts(kind).good)
        if kind not in self.built:
            self.built[kind] = list(self.join(kind))
        return self.built[kind]

    def join(self, kind: type) -> Iterator[Any]:
        options = [self.options(part) for part in input_parts(kind)]
        return (kind(*chosen) for chosen in itertools.product(*options))

    def options(self, part: InputPart) -> list[Any]:
        broken = part.kind in READERS and bool(self.package.parts(part.kind).broken)
        if broken and (part.is_optional or part.is_every) and not part.is_readable:
            return []
        found = self.of(part.kind)
        if part.is_every:
            return [tuple(found)]
        return found or ([None] if part.is_optional else [])


@cache
def input_parts(kind: type) -> tuple[InputPart, ...]:
    """Return the parts of a joined input, as its annotations name them; raises TypeError for any other type."""
    try:
        names = field_names(kind)
    except TypeError as error:
        message = f"{kind.__name__} is neither a model that a reader makes nor a dataclass of such models"
        raise TypeError(message) from error
    hints = typing.get_type_hints(kind, include_extras=True)
    return tuple(input_part(hints[name]) for name in names)


def input_part(hint: Any) -> InputPart:
    origin, arguments = typing.get_origin(hint), typing.get_args(hint)
    if origin is typing.Annotated:
        return input_part(arguments[0])._replace(is_readable=READABLE in arguments)
    if origin in (typing.Union, types.UnionType):
        return InputPart(next(a for a in arguments if a is not type(None)), is_optional=True)
    if origin is tuple:
        return InputPart(arguments[0], is_every=True)
    return InputPart(hint)
