"""What packages export to the targets that are linked with them, as far as package.xml and tables say."""

from __future__ import annotations

from functools import cached_property

from ...light_dataclasses import dataclass
from ...package.workspace import Workspace
from ...ros.aliases import keys_for_cmake
from ...ros.interfaces import OF_INTERFACES
from ...ros.manifest import EXPORTED
from ...ros.names import NameKind
from ...ros.private_links import FROM_JAZZY
from ...ros.read_table import rows
from ..cmake.found_with import TABLES

PASSED_ON = EXPORTED | {"build_depend"}
EVERYWHERE, SOMEWHERE, BEFORE_JAZZY = range(3)
"""On which distributions a package exports another one: all, some that are unknown here, or all up to Humble."""
Needs = tuple[tuple[str, int], ...]


@dataclass(frozen=True)
class BroughtByLinks:
    """What some packages export."""

    names: frozenset[str]
    workspace: Workspace

    @cached_property
    def everywhere(self) -> frozenset[str]:
        return frozenset(self.within(EVERYWHERE))

    def within(self, how: int) -> set[str]:
        """Return the packages, and all that they export on at least the given distributions."""
        known, found = self.workspace.index_of(NeedsOfPackages), set[str]()
        waiting = [*self.names]
        while waiting:
            name = waiting.pop()
            if name not in found:
                found.add(name)
                waiting += [need for need, where in known.of(name, self.workspace) or () if where <= how]
        return found

    @cached_property
    def strangers(self) -> tuple[str, ...]:
        """The packages whose exported dependencies are unknown."""
        known = self.workspace.index_of(NeedsOfPackages)
        return tuple(name for name in sorted(self.within(BEFORE_JAZZY)) if known.of(name, self.workspace) is None)

    def stranger_for(self, name: str) -> str:
        """Return the linked package that may bring another one, as its exports are unknown; "" for none."""
        strangers = {each for each in self.strangers if OF_INTERFACES.fullmatch(name) or not is_of_interfaces(each)}
        return next((each for each in sorted(self.names) if not strangers.isdisjoint(self.of(each))), "")

    def bringer_of(self, name: str, how: int) -> str:
        """Return the first of the packages that exports one."""
        return next(
            each for each in sorted(self.names) if name in BroughtByLinks(frozenset({each}), self.workspace).within(how)
        )

    def of(self, name: str) -> set[str]:
        return BroughtByLinks(frozenset({name}), self.workspace).within(BEFORE_JAZZY)


def is_of_interfaces(name: str) -> bool:
    return OF_INTERFACES.fullmatch(name) is not None


class NeedsOfPackages(dict[str, "Needs | None"]):
    """The exports of packages by name, None where unknown, kept because many targets ask for the same."""

    def of(self, name: str, workspace: Workspace) -> Needs | None:
        if name not in self:
            self[name] = needs_of(name, workspace)
        return self[name]


def needs_of(name: str, workspace: Workspace) -> Needs | None:
    if (facts := workspace.named(name)) is not None:
        declared = {each.name for each in facts.dependencies if each.tag in PASSED_ON} - facts.kept_links
        return tuple((each, EVERYWHERE) for each in sorted(declared | facts.typed_with))
    tables = [*(rows(f"{table}.txt") for table in TABLES), rows("cmake_exports.txt")]
    if any(name in table for table in tables):
        needs = [need for table in tables for need in table.get(name, ())]
        hidden = FROM_JAZZY.get(name, frozenset())
        ways = {need.lstrip("?"): SOMEWHERE for need in needs} | {need: EVERYWHERE for need in needs if need[0] != "?"}
        return tuple((need, BEFORE_JAZZY if need in hidden else how) for need, how in ways.items())
    is_library = (
        workspace.kind_of(name) is NameKind.KEY or bool(keys_for_cmake(name)) or is_plain_library(name, workspace)
    )
    return () if is_library else None


def is_plain_library(name: str, workspace: Workspace) -> bool:
    """Return whether it is what core packages look for, and no package of ROS: `orocos_kdl`, `fcl`."""
    if workspace.kind_of(name) is NameKind.PACKAGE:
        return False
    return any(name in found for found in rows("cmake_exports.txt").values())
