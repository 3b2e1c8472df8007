"""Which packages declare the parameters of a block: found by their names, as no file names the package."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated

from ...light_dataclasses import dataclass
from ...package.package_facts import PackageFacts
from ...package.params.parameter_file import NodeBlock, Parameter, ParameterFile
from ...package.workspace import Workspace
from ...suggest import slips
from ...unreadable import READABLE
from .parameter_group import ParameterGroup

OF_EVERY_NODE = frozenset({"use_sim_time", "start_type_description_service"})
EVERYWHERE = ("qos_overrides.", "bond_")
ENOUGH = 0.6
"""The share of a block's names that a package has to declare to be taken for its owner."""
ALMOST = 0.8
"""The same, where it is about what a block does not set."""
MOST = 0.7
"""The share of what a source file needs that a block has to give to be taken for its file."""


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


def group_of(name: str) -> str:
    """Return what the names of a group begin with: up to a first dot, or to a last slash."""
    return name.rpartition(".")[0].partition(".")[0] or name.rpartition("/")[0]


def is_its_own(name: str) -> bool:
    return name not in OF_EVERY_NODE and not name.startswith(EVERYWHERE)
