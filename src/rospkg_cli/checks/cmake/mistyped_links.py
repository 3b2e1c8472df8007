"""Imported targets that something is linked with, and that are one or two letters off."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...light_dataclasses import dataclass
from ...package.cmake.cmake_package import CMakePackage
from ...package.cmake.target_links import TargetLink, TargetLinks
from ...package.workspace import Workspace
from ...ros.link_targets import ROS_NAME, link_targets
from ...ros.names import NameKind
from .name_slips import is_likely_slip, nearest

SHORTEST = 8
"""Letters of a package's name from which its target may be one letter off."""


@dataclass(frozen=True)
class MistypedLink:
    link: TargetLink
    near: str
    """The target that is certainly there; "" where none is near, or the package exports none at all."""
    exported: tuple[str, ...] | None = None
    """All targets of a package of the workspace of which no other is known; None where something is near."""

    @property
    def is_certain(self) -> bool:
        """Whether a target is near that is likely intended; a package may have one more of a short name."""
        return self.exported is not None or is_likely_slip(self.link.word.text, self.near)


@dataclass(frozen=True)
class MistypedLinks:
    package: CMakePackage
    workspace: Workspace

    def all(self) -> Iterator[MistypedLink]:
        """Yield each argument once, and a target that a package does not export at its first place alone."""
        seen: set[tuple[str, int, str]] = set()
        lost: set[str] = set()
        for link in TargetLinks(self.package.cmake).all:
            word = link.word
            key = (word.path, word.span.start, word.text)
            if word.is_known and not link.package and not word.maybe and not link.call.maybe and key not in seen:
                seen.add(key)
                near = self.near_target(word.text)
                exported = self.all_targets(word.text) if near is None else None
                if (near is None and exported is None) or word.text in lost or self.is_brought(word.text):
                    continue  # last, as it evaluates the CMake of all packages
                if near is None:
                    lost.add(word.text)
                yield MistypedLink(link, near or "", exported)

    def near_target(self, text: str) -> str | None:
        """Return what to write for `package::target`; None where it may exist."""
        package, colons, target = text.partition("::")
        if not colons or text in self.own:
            return None
        if known := self.targets_of(package):
            return None if text in known else nearest(text, known, 2)
        if package in self.found or self.is_known(package):
            return f"{package}::{package}" if is_nearly(target, package) else None
        return nearest(text, {target for name in self.found for target in self.targets_of(name)}, 1)

    def all_targets(self, text: str) -> tuple[str, ...] | None:
        """Return all targets of a package of the workspace that does not export one; None where it may."""
        package, colons, _ = text.partition("::")
        facts = self.workspace.named(package)
        if not colons or text in self.own or facts is None or facts.build_type != "ament_cmake":
            return None
        is_own = facts.name == self.package.facts.name
        unclear = is_own or not facts.knows("cmake_targets") or text in facts.cmake_targets
        return None if unclear else facts.cmake_targets

    def is_brought(self, text: str) -> bool:
        """Return whether a package of the workspace exports a target, maybe into the name of another one."""
        return bool(self.workspace.having("cmake_targets", text))

    def is_known(self, package: str) -> bool:
        known = self.workspace.kind_of(package) in (NameKind.PACKAGE, NameKind.KEY)
        return known or self.workspace.is_available(package)

    def targets_of(self, package: str) -> frozenset[str]:
        """Return the targets of a package that are known; some packages have more."""
        if not ROS_NAME.fullmatch(package):
            return frozenset()
        facts = self.workspace.named(package)
        targets = link_targets(package).targets if facts is None else facts.cmake_targets
        return frozenset(each for each in (*targets, *self.own) if each.startswith(f"{package}::"))

    @cached_property
    def own(self) -> frozenset[str]:
        """The targets that the package makes, under any name."""
        return frozenset(target.name for target in self.package.cmake.targets)

    @cached_property
    def found(self) -> frozenset[str]:
        """The packages that CMake finds, or that the manifest names, which `ament_auto_…` finds."""
        named = {each.name for each in self.package.manifest.dependencies}
        return frozenset({each.name for each in self.package.cmake.packages} | named)


def is_nearly(target: str, package: str) -> bool:
    """Return whether a target is the misspelt name of its package, which is a lower-case word of some length."""
    if target == package:
        return False
    is_alike = len(package) >= SHORTEST and ROS_NAME.fullmatch(package) is not None
    return sorted(target) == sorted(package) or (is_alike and nearest(target, {package}, 1) is not None)
