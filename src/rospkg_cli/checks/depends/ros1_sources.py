"""Targets whose build stops at a source of ROS 1, before anything else that they lack matters."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cached_property

from ...languages.cpp.code_text import code_text
from ...languages.cpp.file import CppFile
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ..cmake.source_targets import SourceTargets
from .header_inclusions import Inclusions
from .ros1_headers import Ros1Headers

CALLS = regex(
    r"(?<![\w:])ros::(?:NodeHandle|Publisher|Subscriber|ServiceServer|ServiceClient|AsyncSpinner|init|spin(?:Once)?)\b"
)
"""Names of roscpp that are different in rclcpp."""
DEFINES = regex(r"\bnamespace\s+ros\b")


@dataclass(frozen=True, slots=True)
class Ros1Use:
    path: str
    name: str
    """The header of ROS 1 that a file includes, or the name that it calls."""

    @property
    def sentence(self) -> str:
        """The end of a message about the same target."""
        return f"; the build stops before that at `{self.path}`, which uses `{self.name}` of ROS 1"


@dataclass(frozen=True)
class Ros1Sources:
    headers: Ros1Headers
    cmake: CMake
    sources: tuple[CppFile, ...]

    def stopping(self, target: str) -> Ros1Use | None:
        """Return the use of ROS 1 that ends the build of a target; None where it has none outside of any `#if`."""
        return self.by_target.get(target, (frozenset(), None))[1]

    def stopping_all(self, paths: Iterable[str]) -> Ros1Use | None:
        """Return a use of ROS 1 where each target that compiles one of some files, itself or by others, has one.

        None where a file is in no target that is known.
        """
        uses: list[Ros1Use | None] = []
        for path in paths if self.has_any else ():
            uses += [use for reached, use in self.by_target.values() if path in reached] or [None]
        return uses[0] if uses and None not in uses else None

    @cached_property
    def has_any(self) -> bool:
        return any(use is not None for _, use in self.by_target.values())

    @cached_property
    def by_target(self) -> dict[str, tuple[frozenset[str], Ros1Use | None]]:
        """Target → the files that the compiler surely opens for it, and the first use of ROS 1 in them."""
        uses = {source.path: use for source in self.sources if (use := self.used_in(source)) is not None}
        if not uses:
            return {}
        files = {source.path: source for source in self.sources}
        inclusions, targets = Inclusions(files, only_certain=True, unconditional=True), SourceTargets(self.cmake)
        found: dict[str, tuple[frozenset[str], Ros1Use | None]] = {}
        for target in self.cmake.targets:
            reached = inclusions.reached(path for path in files if target.name in targets.targets_of(path))
            first = next((uses[path] for path in sorted(reached) if path in uses), None)
            found[target.name] = (frozenset(reached), first)
        return found

    def used_in(self, source: CppFile) -> Ros1Use | None:
        """Return the first use of ROS 1 in a file itself; a file that asks what is there leaves the choice open."""
        text = source.source.text
        if "__has_include" in text:
            return None
        for each in source.includes:
            header = self.headers.find(each.path) if not each.is_conditional else None
            if header is not None and header.is_certain:
                return Ros1Use(source.path, each.path)
        is_named = "ros::" in text and not self.defines_ros
        called = CALLS.search(code_text(text)) if is_named and CALLS.search(text) else None
        return Ros1Use(source.path, called[0]) if called is not None else None

    @cached_property
    def defines_ros(self) -> bool:
        """Whether a file of the package has the namespace of roscpp, for code that stays as it is."""
        return any(DEFINES.search(source.source.text) for source in self.sources)
