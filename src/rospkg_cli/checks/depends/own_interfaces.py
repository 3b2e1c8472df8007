"""Headers that rosidl generates in a package, and targets of it that are not linked with them (CMK121)."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...languages.cmake.evaluated_command import path_in_package
from ...languages.cmake.targets import Target
from ...languages.cmake.values import BINARY, UNKNOWN
from ...light_dataclasses import dataclass
from ...package.cmake.foreign_commands import foreign_commands
from ...ros.interfaces import KINDS
from ...source import Span
from .ros1_sources import Ros1Use
from .unlinked_includes import PLAIN, UnlinkedIncludes

TYPESUPPORT = "typesupport"
"""Part of the name of each library that rosidl makes."""
FOLDERS = "target_include_directories"


@dataclass(frozen=True, slots=True)
class OwnInterface:
    target: Target
    header: str
    path: str
    span: Span
    behind: Ros1Use | None
    """What of ROS 1 ends the build of the target."""


@dataclass(frozen=True)
class OwnInterfaces:
    unlinked: UnlinkedIncludes

    def all(self) -> Iterator[OwnInterface]:
        """Yield the first generated header of each target that can't find it."""
        cmake = self.unlinked.includes.cmake
        is_known = cmake.is_complete and not cmake.reads_unknown_files
        is_known = is_known and self.unlinked.linked.folders.for_all is not None
        finds_itself = any(each.name == self.name for each in cmake.packages)
        if not is_known or finds_itself or not cmake.interface_targets or next(foreign_commands(cmake), None):
            return
        if any(not call.words or UNKNOWN in call.texts[0] for call in cmake.named("rosidl_target_interfaces", FOLDERS)):
            return
        for target in cmake.targets:
            is_plain = target.call.name in PLAIN and target.is_built
            if is_plain and not (target.call.maybe or target.call.testing or self.may_find(target.name)):
                found = next(self.included(target), None)
                if found is not None:
                    yield found

    @property
    def name(self) -> str:
        return self.unlinked.includes.declared.facts.name

    def may_find(self, target: str) -> bool:
        """Return whether a target, or one that it is linked with, may find the generated headers."""
        cmake = self.unlinked.includes.cmake
        given = {call.texts[0] for call in cmake.named("rosidl_target_interfaces")}
        seen, left = set[str](), [target]
        while left:
            name = left.pop()
            folders = [word for call in cmake.named(FOLDERS) if call.texts[0] == name for word in call.words[1:]]
            if name in given | self.generated or any(not w.is_known or BINARY in w.text for w in folders):
                return True
            seen.add(name)
            for link in self.unlinked.linked.links.of(name):
                text, own = link.word.text, self.unlinked.linked.links.own(link.word.text)
                is_linked = text in self.generated or (link.package and text == self.name)
                if not link.word.is_known or TYPESUPPORT in text or is_linked:
                    return True
                left += [own.name] if own is not None and own.name not in seen else []
        return False

    @cached_property
    def generated(self) -> frozenset[str]:
        """The targets of the interfaces, which are no libraries: CMK110 reports links with them."""
        return frozenset(each.target.text for each in self.unlinked.includes.cmake.interface_targets)

    def included(self, target: Target) -> Iterator[OwnInterface]:
        """Yield the generated headers that the sources of a target include in any case, also by its own headers."""
        unlinked = self.unlinked
        words = (word for word in target.sources if word.is_known and not word.maybe)
        paths = {path_in_package(word.text, target.call.folder) for word in words}
        there = unlinked.includes.files.paths
        for path in sorted(unlinked.opened.inclusions.reached(path for path in paths if path in unlinked.opened.files)):
            for each in unlinked.opened.files[path].includes:
                first, _, rest = each.path.partition("/")
                is_generated = first == self.name and rest.partition("/")[0] in KINDS and not each.is_conditional
                if is_generated and not any(other.endswith(f"/{each.path}") for other in there):
                    use = unlinked.includes.ros1.stopping(target.name)
                    yield OwnInterface(target, each.path, path, each.span, use)
