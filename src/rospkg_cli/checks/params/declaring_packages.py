"""Which packages declare the parameters of a block: found by their names, as no file names the package."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...languages.cpp.file import CppFile
from ...languages.yaml.nodes import ScalarNode, YamlNode
from ...languages.yaml.nodes import SequenceNode as YamlSequence
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.package_facts import PackageFacts
from ...package.params.cpp_parameters import read_in
from ...package.params.declared_parameter import DeclaredParameter, type_named
from ...package.params.parameter_file import NodeBlock, Parameter, ParameterFile
from ...package.params.scalar_types import type_of
from ...package.workspace import Workspace
from ...source import Span
from ...suggest import near_names, nearest

OF_EVERY_NODE = frozenset({"use_sim_time", "start_type_description_service"})
EVERYWHERE = ("qos_overrides.", "bond_")
ENOUGH = 0.6
"""The share of a block's names that a package has to declare to be taken for its owner."""
ALMOST = 0.8
"""The same, where it is about what a block does not set."""
ALLOWED = regex(r"allow_undeclared_parameters|automatically_declare_parameters_from_overrides")
"""Options of a node that has parameters which no code declares."""
MILD = regex(r"\bcatch\b|\bhas_parameter\b")
MOST = 0.7
"""The share of what a source file needs that a block has to give to be taken for its file."""


@dataclass(frozen=True)
class ParameterGroup:
    """Parameters of a block that belong together: those without a prefix, or all of one prefix, and their owners."""

    file: ParameterFile
    block: NodeBlock
    prefix: str
    parameters: tuple[Parameter, ...]
    owners: tuple[PackageFacts, ...]
    """The packages that declare most of them; none where that is unknown."""

    def fitting(self, name: str) -> list[DeclaredParameter]:
        return [each for facts in self.owners for each in facts.parameters if each.fits(name)]

    def unknown(self) -> Iterator[tuple[Parameter, str]]:
        """Yield the parameters that no owner declares, where one that is declared and not set has a similar name."""
        given = {each.name for each in self.block.parameters}
        for parameter in self.parameters:
            if not self.fitting(parameter.name):
                before, _, last = parameter.name.rpartition(".")
                prefix = f"{before}." if before else ""
                free = {name for name in self.last_names if prefix + name not in given and self.fitting(prefix + name)}
                found = near_names(last, free)
                if len(found) == 1:
                    yield parameter, prefix + found[0]

    @cached_property
    def last_names(self) -> frozenset[str]:
        """The last pieces of the names that the owners declare."""
        return frozenset(each.name.rpartition(".")[2] for facts in self.owners for each in facts.parameters)

    def type_of(self, name: str) -> str:
        """Return the type that every owner declares a name with; "" where they differ."""
        return type_named(self.fitting(name), name)

    def wanted_type(self, parameter: Parameter) -> tuple[str, DeclaredParameter] | None:
        """Return the type that every owner declares a parameter with, and one declaration; None where they differ."""
        fitting = self.fitting(parameter.name)
        wanted = type_named(fitting, parameter.name)
        return (wanted, fitting[0]) if wanted else None


@dataclass(frozen=True, slots=True)
class UnknownRead:
    path: str
    span: Span
    name: str
    suggestion: str
    throws: bool
    """Whether it certainly throws: it gets one parameter by its name, and nothing in the file may catch that."""


@dataclass(frozen=True, slots=True)
class IncompleteBlock:
    file: ParameterFile
    block: NodeBlock
    facts: PackageFacts
    path: str
    """The source file that declares them."""
    names: tuple[str, ...]


@dataclass(frozen=True)
class ParameterContext:
    """The parameter files of a package, its code, and the code of its neighbours."""

    files: tuple[ParameterFile, ...]
    cpp: tuple[CppFile, ...]
    package: PackageFacts
    workspace: Workspace

    def groups(self) -> Iterator[ParameterGroup]:
        """Yield the groups of parameters whose owners are known."""
        for file in self.files:
            yield from self.groups_of(file)

    def groups_of(self, file: ParameterFile) -> Iterator[ParameterGroup]:
        for block in file.blocks:
            parts: dict[str, list[Parameter]] = {}
            for each in block.parameters:
                if is_its_own(each.name):
                    parts.setdefault(each.name.rpartition(".")[0].partition(".")[0], []).append(each)
            for prefix, parameters in parts.items():
                owners = self.owners(frozenset(each.name for each in parameters))
                if owners:
                    yield ParameterGroup(file, block, prefix, tuple(parameters), tuple(owners))

    def left_out(self) -> Iterator[IncompleteBlock]:
        """Yield the blocks that are copies of one that the declaring package ships, and do not set all that it sets.

        That is what a source file declares without a default, of which the copy sets most.
        """
        for file in self.files:
            for block in file.blocks:
                index = self.workspace.parameters
                names = frozenset(each.name for each in block.parameters if is_its_own(each.name))
                counts = index.counts(names)
                own = max((count for facts, count in counts if facts.folder == self.package.folder), default=0)
                for facts, count in counts:
                    if count < max(ALMOST * len(names), own + 1):
                        break  # the most come first
                    for path, needed in index.required(facts).items():
                        given = needed & names
                        shipped = [each for each in facts.given_parameters if len(each & needed) >= MOST * len(needed)]
                        missing = needed.intersection(*shipped) - names if shipped else set()
                        enough = len(given) >= max(3, MOST * len(needed))
                        if enough and missing and facts.folder != self.package.folder:
                            yield IncompleteBlock(file, block, facts, path, tuple(sorted(missing)))

    def unknown_reads(self) -> Iterator[UnknownRead]:
        """Yield what a C++ file gets and no code declares, where the same file declares something that no code gets.

        It has a similar name, or there is only one of each.
        """
        reads = [read for file in self.cpp for read, _ in read_in(file)]
        for file in self.cpp if not any(ALLOWED.search(each.source.text) for each in self.cpp) else ():
            own = [each for each in self.package.parameters if each.path == file.path]
            unread = {each.name for each in own if not any(same(each, read) for read in reads)}
            unmatched = [
                (read, call)
                for read, call in read_in(file)
                if unread and is_its_own(read.name) and not self.is_declared(read)
            ]
            for read, call in unmatched:
                only = len(unread) == 1 and len({read.name for read, _ in unmatched}) == 1
                suggestion = next(iter(unread)) if only else nearest(read.name, unread)
                if suggestion is not None and call.arguments:
                    throws = len(call.arguments) == 1 and not MILD.search(file.source.text)
                    yield UnknownRead(file.path, call.arguments[0].span, read.name, suggestion, throws)

    def is_declared(self, read: DeclaredParameter) -> bool:
        if any(same(each, read) for each in self.package.parameters):
            return True
        return any(same(each, read) for facts in self.workspace.packages for each in facts.parameters)

    def owners(self, names: frozenset[str]) -> list[PackageFacts]:
        """Return the packages that declare most of the names.

        Of a single name only the own package is believed, of two only one that this package depends on: `type` and
        `frame_id` are declared by many.
        """
        found, near, is_certain = [], {each.name for each in self.package.dependencies}, False
        for facts, count in self.workspace.parameters.counts(names):
            own = facts.folder == self.package.folder
            if count < ENOUGH * len(names):
                break
            if count > 1 or (own and len(names) < 3):
                found.append(facts)
                is_certain = is_certain or own or facts.name in near or count > 2
        return found if is_certain else []


def same(declared: DeclaredParameter, read: DeclaredParameter) -> bool:
    """Return whether a read may mean what is declared."""
    return declared.name == read.name or declared.fits(read.name) or read.fits(declared.name)


def is_its_own(name: str) -> bool:
    return name not in OF_EVERY_NODE and not name.startswith(EVERYWHERE)


def given_type(value: YamlNode) -> str:
    """Return the type that rcl gives a value; "" where it has none, or it is filled in later."""
    if isinstance(value, ScalarNode):
        return "" if "$(" in value.text or (value.is_plain and not value.text) else type_of(value)
    if isinstance(value, YamlSequence) and value.items:
        types = {given_type(item) for item in value.items}
        only = types.pop() if len(types) == 1 else ""
        return f"{only}[]" if only and "[" not in only else ""
    return ""
