"""What is given to nodes, controllers and plugins of well-known packages, with what these declare."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import cached_property
from typing import Literal

from ...languages.yaml.nodes import ScalarNode
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.launch.launch_file import LaunchFile
from ...package.launch.text import LaunchText
from ...package.params.parameter_file import NodeBlock, Parameter, ParameterFile
from ...package.params.scalar_types import DOUBLE, FALSE, TRUE, yaml_type
from ...ros.known_nodes import KnownParameter, known_nodes, known_parameters, removed_parameters
from ...ros.well_known import packages_with_plugin
from ...source import Span
from .costmap_blocks import is_out_of_reach
from .declaring_packages import given_type, is_its_own
from .idle_nodes import Start, start_of
from .launch_parameters import LaunchParameters, NodeArguments
from .mistyped_blocks import MANAGER, TYPE, WILD, last
from .plugin_lists import is_unloaded
from .unchanged_values import value_text

PLUGIN = ".plugin"
SEVERAL = 3
"""Blocks of well-known nodes in one file, by which it is one for all of them: nav2's."""
SELDOM = frozenset({"map_saver"})
"""Nodes with a block in each such file that are seldom started."""
CONVERTED = regex(r"ParameterValue|value_type|type=")
"""What gives a value in a launch file another type than its text has."""


PartKind = Literal["node", "controller", "plugin"]


@dataclass(frozen=True, slots=True)
class GivenValue:
    name: str
    key: Span
    value: Span
    text: str
    type: str
    """"" where it is unknown."""
    written: Parameter | None = None
    """In a parameter file."""

    @property
    def plain(self) -> str | None:
        """What is given where it is one value: the text of a launch file, or that of a parameter file; else None."""
        return value_text(self.written.value) if self.written is not None else self.text or None


@dataclass(frozen=True)
class KnownGroup:
    """Values that one node, controller or plugin gets."""

    path: str
    kind: PartKind
    packages: tuple[str, ...]
    """Well-known packages, each of which may be the one that has the node."""
    values: tuple[GivenValue, ...]
    file: ParameterFile | None = None
    """The file that gives them; None for a launch file."""
    is_certain: bool = True
    """Whether the node is certainly of one of the packages, and started: not by its name alone, nor a plugin that no
    list of its block names.
    """
    start: Start | None = None
    """Where a launch file starts the node; None for a file."""

    @cached_property
    def declared(self) -> tuple[KnownParameter, ...]:
        return tuple(each for package in self.packages for each in known_parameters(package))

    @cached_property
    def removed(self) -> tuple[KnownParameter, ...]:
        return tuple(each for package in self.packages for each in removed_parameters(package))

    def is_declared_by(self, package: str, name: str) -> bool:
        return any(each.fits(name) for each in known_parameters(package))

    def wanted_type(self, name: str) -> str:
        """Return the type that all declarations of a name have; "" where there is none."""
        types = {each.type for each in self.declared if each.fits(name)}
        return types.pop() if len(types) == 1 else ""


@dataclass(frozen=True)
class KnownNodes:
    launched: LaunchParameters

    def groups(self) -> Iterator[KnownGroup]:
        """Yield what launch files and parameter files give."""
        for each in self.launched.started:
            package = each.node.package.literal if each.node.package else None
            if package and self.is_known(package):
                entries = (pair for entry in each.node.parameters for pair in entry.values)
                values = tuple(found for name, value in entries for found in launch_value(each.launch, name, value))
                start = start_of(each.launch, each.node, self.launched.workspace)
                yield KnownGroup(each.launch.path, "node", (package,), values, start=start)
        for file in self.launched.files:
            kinds = dict(controller_types(file))
            for block in file.blocks:
                if not is_out_of_reach(block, self.launched):
                    yield from self.of_block(file, block, kinds)

    def of_block(self, file: ParameterFile, block: NodeBlock, kinds: dict[str, str]) -> Iterator[KnownGroup]:
        """Yield the values of a block: those of the node, and those below the name of each plugin."""
        plugins = {
            each.name.removesuffix(PLUGIN): each.value.text
            for each in block.parameters
            if each.name.endswith(PLUGIN) and isinstance(each.value, ScalarNode)
        }
        parts: dict[str, list[Parameter]] = {}
        for each in block.parameters:
            owner = max((name for name in plugins if each.name.startswith(f"{name}.")), key=len, default="")
            if is_its_own(each.name) and each.name != owner + PLUGIN:
                parts.setdefault(owner, []).append(each)
        for owner, parameters in parts.items():
            packages = self.having(plugins[owner]) if owner else self.behind(file, block, kinds)
            if packages:
                kind: PartKind = "plugin" if owner else "controller" if last(block) in kinds else "node"
                is_certain = kind != "node" or self.is_certain(file, block)
                is_certain = is_certain and not (kind == "plugin" and is_unloaded(block, owner))
                yield KnownGroup(file.path, kind, packages, tuple(map(file_value, parameters)), file, is_certain)

    def readers(self, file: ParameterFile, key: str) -> list[NodeArguments]:
        """Return the nodes that launch files give a file, and that read a block of a name."""
        given = (each for each in self.launched.node_arguments if file in each.files)
        return [each for each in given if key in WILD or key in (each.name, each.usual_name) or each.usual_name is None]

    def is_certain(self, file: ParameterFile, block: NodeBlock) -> bool:
        """Return whether a launch file gives the node the file, or it stands among several nodes of well-known sets."""
        if self.readers(file, last(block)):
            return True
        together = {last(each) for each in file.blocks} & known_nodes().keys()
        return len(together) >= SEVERAL and last(block) not in SELDOM

    def behind(self, file: ParameterFile, block: NodeBlock, kinds: dict[str, str]) -> tuple[str, ...]:
        """Return the packages of the nodes that a block is for; none where not all of them are known."""
        key = last(block)
        if key in kinds:
            return self.having(kinds[key])
        readers = self.readers(file, key)
        named = {each.node.package.literal if each.node.package else None for each in readers}
        found = named or set(known_nodes().get(key, ()))
        return tuple(sorted(each or "" for each in found)) if all(map(self.is_known, found)) else ()

    def having(self, plugin: str) -> tuple[str, ...]:
        """Return the packages that have a plugin; none where one is in the workspace."""
        found = packages_with_plugin(plugin)
        return found if all(map(self.is_known, found)) else ()

    def is_known(self, package: str | None) -> bool:
        """Return whether a package is well-known, and not among those whose sources are here."""
        return bool(package and known_parameters(package)) and self.launched.workspace.named(package or "") is None


def controller_types(file: ParameterFile) -> Iterator[tuple[str, str]]:
    """Yield the controllers that controller managers of a file load, with their types."""
    for block in file.blocks:
        for each in block.parameters if last(block).endswith(MANAGER) else ():
            if each.name.endswith(TYPE) and isinstance(each.value, ScalarNode):
                yield each.name.removesuffix(TYPE), each.value.text


def file_value(each: Parameter) -> GivenValue:
    return GivenValue(each.name, each.key.span, each.value.span, "", given_type(each.value), each)


def launch_value(launch: LaunchFile, name: LaunchText, value: LaunchText) -> Iterable[GivenValue]:
    """Return a value under a literal name; its type is that of its text, as launch_ros reads it."""
    if not name.literal or not is_its_own(name.literal):
        return ()
    text, source = value.literal or "", launch.source
    is_written = source.slice(value.span) == text and name.span.end <= value.span.start
    before = source.text[name.span.end : value.span.start] if is_written else ""
    kind = type_of_text(text) if is_written and not CONVERTED.search(before) else ""
    kind = "" if is_cast_behind(launch, value) else kind
    if kind and launch.frontend != "xml" and before[-1:] in ("'", '"'):
        kind = "string" if launch.frontend == "python" and not is_number_of_rcl(text) else ""
    return (GivenValue(name.literal, name.span, value.span, text, kind),)


def is_cast_behind(launch: LaunchFile, value: LaunchText) -> bool:
    """Return whether XML names the type of a value behind it."""
    end = value.span.end
    return launch.frontend == "xml" and "type=" in launch.source.text[end : launch.source.text.find(">", end)]


def is_number_of_rcl(text: str) -> bool:
    """Return whether PyYAML writes a text without quotes that rcl reads as a number: `1e-3`."""
    return yaml_type(text) == "string" and bool(DOUBLE.fullmatch(text))


def type_of_text(text: str) -> str:
    """Return the type of a text that PyYAML reads; "" for what is no plain scalar."""
    if not text.strip() or text[0] in "[{'\"|>&*!":
        return ""
    return "bool" if text in TRUE | FALSE and len(text) > 1 else yaml_type(text)
