"""Rule input: components that launch files load, compared with those that packages register (LCH011)."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import Annotated

from ...light_dataclasses import dataclass, replace
from ...package.launch.launch_file import LaunchFile
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from ...ros.names import NameKind
from ...ros.well_known import wrong_name
from ...unreadable import READABLE
from ..cmake.component_registration import ComponentRegistration
from ..fault import Level
from ..repository.older_distribution import OlderDistribution
from .one_cause import CausedPlace, reported_in
from .unknown_component import UnknownComponent, is_unregistered, tail
from .who_meets import level_met


@dataclass(frozen=True)
class LoadedComponents:
    workspace: Workspace
    file: LaunchFile
    own: ComponentRegistration | None
    package: PackageFacts
    distribution: OlderDistribution
    around: Annotated[tuple[LaunchFile, ...], READABLE] = ()
    """All launch files of the package that can be read."""

    def unknown_together(self) -> Iterator[list[CausedPlace[UnknownComponent]]]:
        """Yield the places of each unknown component that is reported in this file; the worst is first."""
        others = (file for file in self.around if file.path != self.file.path)
        files = (self.file, *others) if next(self.unknown(), None) else ()
        every = [replace(self, file=file) for file in files]
        places = [
            CausedPlace((each.package, each.name), one.level_of(each)[0], one.file.path, each.plugin.span, each)
            for one in every
            for each in one.unknown()
        ]
        yield from reported_in(self.file.path, places)

    def level_of(self, each: UnknownComponent) -> tuple[Level | None, str]:
        """Return the level of a component, None for the rule's own, and why it is not that."""
        level, why = level_met(self.file, each.plugin.span, self.workspace)
        if each.wrong is None or not each.wrong.is_removed:
            return level, why
        if self.distribution.is_for_unsupported(self.file.path):
            return "info", "but in the distributions that the pages name"
        from .forked_packages import is_of_fork  # few launch files load a removed component

        if is_of_fork(each.package, self.package, self.workspace):
            return "info", "but in a fork, it may be there"
        if not (level == "info" or self.distribution.is_newer_shown):
            return "info", "but in older distributions, and nothing here names later ones alone"
        return level or "warning", why

    @cached_property
    def reported_elsewhere(self) -> frozenset[tuple[str, str]]:
        """The classes that a source here registers and CMake does not, or under another name: CMK108 reports them."""
        if self.own is None or not self.own.package.is_ament:
            return frozenset()
        names = {each.name for each in self.own.without_cmake()} | self.own.misspelt
        return frozenset((self.own.package.facts.name, name) for name in names)

    def unknown(self) -> Iterator[UnknownComponent]:
        """Yield components that their package, whose components are all known, does not register."""
        for node in {node.plugin: node for node in self.file.nodes}.values() if not self.file.is_ros1 else ():
            package = node.package.literal if node.package else None
            name = node.plugin.literal if node.plugin else None
            if node.kind != "composable_node" or not package or not name or node.plugin is None:
                continue
            facts, plain = self.workspace.named(package), self.file.source.slice(node.plugin.span) == name
            if facts is not None:
                known = name in facts.components or (package, name) in self.reported_elsewhere
                if not known and is_unregistered(name, facts):
                    yield UnknownComponent(package, node.plugin, name, facts, self.elsewhere(name, facts), plain)
            elif wrong := wrong_name("components", package, name):
                yield UnknownComponent(package, node.plugin, name, None, (), plain, wrong)
            elif found := self.renamed(package, name):
                yield UnknownComponent(package, node.plugin, name, None, found, plain)

    def renamed(self, package: str, name: str) -> tuple[tuple[str, str], ...]:
        """Return who registers the class of an unknown package; nothing where that may be another class."""
        known = self.workspace.kind_of(package)
        found = () if known is NameKind.PACKAGE else self.elsewhere(name, None)
        longer = len(found) == 1 and found[0][0].endswith(f"_{package}")
        return found if known is NameKind.UNKNOWN or longer else ()

    def elsewhere(self, name: str, but: PackageFacts | None) -> tuple[tuple[str, str], ...]:
        """Return who registers a class of this name, or else a class of the same last name."""
        every = [
            (facts.name, each) for facts in self.workspace.packages if facts is not but for each in facts.components
        ]
        last = tail(name)
        exact = tuple(sorted(pair for pair in every if pair[1] == name))
        return exact or tuple(sorted(pair for pair in every if tail(pair[1]) == last))
