"""Which packages declare the parameters of a block: found by their names, as no file names the package."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from functools import cached_property
from typing import Annotated

from ...languages.yaml.nodes import ScalarNode, YamlNode
from ...languages.yaml.nodes import SequenceNode as YamlSequence
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.package_facts import PackageFacts
from ...package.params.declared_parameter import DeclaredParameter, type_named
from ...package.params.parameter_file import NodeBlock, Parameter, ParameterFile, has_placeholder
from ...package.params.scalar_types import type_of
from ...package.workspace import Workspace
from ...suggest import near_names, same_words, slips
from ...unreadable import READABLE
from .unchanged_values import declared_defaults, same_as_default, value_text

OF_EVERY_NODE = frozenset({"use_sim_time", "start_type_description_service"})
EVERYWHERE = ("qos_overrides.", "bond_")
ENOUGH = 0.6
"""The share of a block's names that a package has to declare to be taken for its owner."""
ALMOST = 0.8
"""The same, where it is about what a block does not set."""
BLOCK_WORD = 4
"""Letters of a word that stands for the block: `segment` in `segmentation`."""
MOST = 0.7
"""The share of what a source file needs that a block has to give to be taken for its file."""

PLACEHOLDER = regex(r"<.*>|[A-Z][A-Z0-9]*(?:_[A-Z0-9]+)+|__\w+__|.*[{}@%].*")
"""A text that a launch file replaces before the node gets it."""


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
        return [each for each in self._by_last.get(name.rpartition(".")[2], ()) if each.fits(name)]

    @cached_property
    def _by_last(self) -> dict[str, list[DeclaredParameter]]:
        """What the owners declare, by the last piece of its name, which is that of all names that it fits."""
        found: dict[str, list[DeclaredParameter]] = {}
        for each in (each for facts in self.owners for each in facts.parameters):
            found.setdefault(each.name.rpartition(".")[2], []).append(each)
        return found

    def unknown(self) -> Iterator[tuple[Parameter, str]]:
        """Yield the parameters that no owner declares, where one that is declared and not set has a similar name."""
        given = {each.name for each in self.block.parameters}
        for parameter in self.parameters:
            if not self.fitting(parameter.name):
                before, _, last = parameter.name.rpartition(".")
                prefix = f"{before}." if before else ""
                free = {name for name in self.last_names if prefix + name not in given and self.fitting(prefix + name)}
                found = near_names(last, free) or same_words(last, free) or but_for_its_block(last, before, free)
                if len(found) == 1:
                    yield parameter, prefix + found[0]

    @cached_property
    def last_names(self) -> frozenset[str]:
        """The last pieces of the names that the owners declare."""
        return frozenset(self._by_last)

    def type_of(self, name: str) -> str:
        """Return the type that every owner declares a name with; "" where they differ."""
        return type_named(self.fitting(name), name)

    def same_as_default(self, parameter: Parameter, name: str) -> str:
        """Return why nobody misses the value of a parameter that is for another name; "" where something may differ."""
        defaults = declared_defaults(self.owners, name)
        return same_as_default(value_text(parameter.value), name.rpartition(".")[2], defaults)

    def wanted_type(self, parameter: Parameter) -> tuple[str, DeclaredParameter] | None:
        """Return the type that every owner declares a parameter with, and one declaration; None where they differ."""
        fitting = self.fitting(parameter.name)
        wanted = type_named(fitting, parameter.name)
        return (wanted, fitting[0]) if wanted else None


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
    """The parameter files of a package, and what its code and that of its neighbours declares."""

    files: Annotated[tuple[ParameterFile, ...], READABLE]
    package: PackageFacts
    workspace: Workspace

    def groups(self) -> Iterator[ParameterGroup]:
        """Yield the groups of parameters whose owners are known."""
        for file in self.files:
            yield from self.groups_of(file)

    def groups_of(self, file: ParameterFile) -> Iterator[ParameterGroup]:
        for block in file.blocks:
            if self.workspace.having("parsed_keys", block.name):
                continue  # a launch file reads it, and gives its values to who wants them
            parts: dict[str, list[Parameter]] = {}
            for each in block.parameters:
                if is_its_own(each.name):
                    parts.setdefault(group_of(each.name), []).append(each)
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
                own = index.count_in(self.package.folder, names)
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

    def owners(self, names: frozenset[str]) -> list[PackageFacts]:
        """Return the packages that declare most of the names.

        Of a single name only the own package is believed, of two only one that this package depends on: `type` and
        `frame_id` are declared by many. Of two the own one may declare one, where the other is a slip of what it does.
        """
        found, near, is_certain = [], {each.name for each in self.package.dependencies}, False
        index = self.workspace.parameters
        for facts, count in index.counts(names):
            if count < ENOUGH * len(names) or count == 1:
                break
            found.append(facts)
            is_certain = is_certain or facts.folder == self.package.folder or facts.name in near or count > 2
        is_alone = index.count_in(self.package.folder, names) == 1 and (len(names) == 1 or self.has_slip(names))
        return [*found, self.package] if is_alone else found if is_certain else []

    def has_slip(self, names: frozenset[str]) -> bool:
        """Return whether one of two names is a slip of another that the package declares."""
        declared = {each.name for each in self.package.parameters}
        return len(names) == 2 and any(slips(name, declared - names) for name in names - declared)


def but_for_its_block(name: str, before: str, names: Collection[str]) -> list[str]:
    """Return the names that a name is but for words of the block that it is in: `segmentation.min_points_segment`."""
    around = [word for word in before.replace(".", "_").split("_") if len(word) >= BLOCK_WORD]
    words = name.split("_")
    own = [each for each in words if not any(alike(each, word) for word in around)]
    return [each for each in names if own and len(own) < len(words) and each.split("_") == own]


def alike(word: str, other: str) -> bool:
    return len(word) >= BLOCK_WORD and (word.startswith(other) or other.startswith(word))


def group_of(name: str) -> str:
    """Return what the names of a group begin with: up to a first dot, or to a last slash."""
    return name.rpartition(".")[0].partition(".")[0] or name.rpartition("/")[0]


def is_its_own(name: str) -> bool:
    return name not in OF_EVERY_NODE and not name.startswith(EVERYWHERE)


def given_type(value: YamlNode) -> str:
    """Return the type that rcl gives a value; "" where it has none, or it is filled in later."""
    if isinstance(value, ScalarNode):
        is_open = value.is_plain and (not value.text or PLACEHOLDER.fullmatch(value.text))
        return "" if is_open or has_placeholder(value.text) else type_of(value)
    if isinstance(value, YamlSequence) and value.items:
        types = {given_type(item) for item in value.items}
        only = types.pop() if len(types) == 1 else ""
        return f"{only}[]" if only and "[" not in only else ""
    return ""
