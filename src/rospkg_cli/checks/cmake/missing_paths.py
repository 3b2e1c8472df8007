"""Paths that CMake installs or compiles and that do not exist, and whether the build stops for everyone."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from posixpath import splitext

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.cmake.intended_paths import intended_path
from ...package.cmake.referenced_paths import ReferencedPath, ReferencedPaths
from ...suggest import near_names
from .branch_names import names_around
from .distro_guards import guarded_commands
from .install_arguments import FOREIGN
from .name_slips import differ_in_long_words, digits
from .switched_off import SwitchedOff

ASKED_FOR = regex(r"EXISTS|IS_DIRECTORY|ROS_VERSION|ROS1|CATKIN|catkin|ROS_DISTRO")
"""What a condition tests for before it names what is not always there: the path itself, or ROS 1."""
OTHER_SYSTEMS = regex(r"\b(?:WIN32|MSVC|MINGW|APPLE|ANDROID|IOS|Windows|Darwin)\b")
PROCESSORS = regex(r"(?i)aarch64|\barm(?:64|hf|v\d\w*)?\b|riscv|ppc64|i\d86")

STOPPING = ("test", "subdirectory", "extras")
"""What stops CMake at once, where it gets there, as sources do."""


@dataclass(frozen=True)
class MissingPaths:
    cmake: CMake

    def all(self) -> Iterator[tuple[ReferencedPath, bool]]:
        """Yield each path, and whether the build stops for everyone who runs it."""
        named = ReferencedPaths(self.cmake)
        for each in named.missing():
            if each.word.text in FOREIGN and not each.word.quoted:
                continue
            perhaps = each.call.maybe or each.word.maybe
            is_unjudged = each.use == "matching" or not self.is_judged(each) if perhaps else False
            if is_unjudged or (perhaps and id(each.call.command) in self.asked_for):
                continue
            yield each, not perhaps and not (each.use != "source" and named.made.is_worked_in)

    def is_judged(self, named: ReferencedPath) -> bool:
        """Return whether a missing path under a condition is reported.

        A source is; of others a path that is near to a file or a folder, and of those that are installed, and may be
        made until then, one that is a letter or two off.
        """
        if named.use == "source":
            return True
        near = intended_path(self.cmake, named)
        if near is None or named.use in STOPPING:
            return near is not None
        stem, other = splitext(named.path)[0], splitext(near)[0]
        return digits(stem) == digits(other) and differ_in_long_words(stem, other) and bool(near_names(stem, [other]))

    def is_elsewhere(self, named: ReferencedPath) -> bool:
        """Return whether a path is named in a branch for another system than Linux, or another processor than most."""
        is_for_some = named.call.maybe or named.word.maybe
        command = id(named.call.command)
        return is_for_some and (command in self.of_other_systems or bool(self.of_processors.get(command)))

    def is_idle(self, named: ReferencedPath) -> bool:
        """Return whether a path is named in a branch that is not taken on Linux, or that nothing here turns on."""
        return self.is_elsewhere(named) or self.off.has(named.call) or self.off.is_never_run(named.call)

    @cached_property
    def of_other_systems(self) -> frozenset[int]:
        """The commands inside an `if` that tests for Windows, macOS or the like."""
        return frozenset(id(each) for file in self.cmake.files for each in guarded_commands(file.body, OTHER_SYSTEMS))

    @cached_property
    def of_processors(self) -> dict[int, tuple[str, ...]]:
        """Command → the processors, of those that few have, for which the branches are that it is in."""
        return names_around(self.cmake, lambda texts: filter(PROCESSORS.search, texts))

    @cached_property
    def off(self) -> SwitchedOff:
        return SwitchedOff(self.cmake)

    @cached_property
    def asked_for(self) -> frozenset[int]:
        """The commands inside an `if` that tests for what they need."""
        return frozenset(id(each) for file in self.cmake.files for each in guarded_commands(file.body, ASKED_FOR))
