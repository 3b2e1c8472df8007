"""Commands that nothing defines and that are one or two letters off a command of CMake or ament."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...languages.cmake.commands import COMMANDS
from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.targets import MAKERS
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...ros.read_table import words
from ...suggest import distance, near_names, same_words
from .name_slips import digits

SHORTEST = 6
"""Letters; a shorter name that is unknown may be anybody's."""
RESERVED = ("ament", "rosidl", "rclcpp", "pluginlib")
"""First words of commands that are all known."""
FEWEST = 3
"""Words of a command that another one shares with it."""
SHORT = 8
"""Letters of a name from which two may be wrong."""


@dataclass(frozen=True)
class UnknownCommands:
    cmake: CMake

    def all(self) -> Iterator[tuple[EvaluatedCommand, str]]:
        """Yield what is certainly called, each place once, and the command that is intended."""
        if self.cmake.reads_unknown_files:
            return
        seen: set[tuple[str, int]] = set()
        for call in self.cmake.calls:
            place = (call.path, call.command.span.start)
            if call.maybe or call.name in self.known or place in seen:
                continue
            seen.add(place)
            if near := self.nearest(call.name):
                yield call, near

    def nearest(self, name: str) -> str | None:
        """Return the command that is intended by one that is unknown.

        None where all its words are those of commands: `add_gtest` may be somebody's own, and where it begins like a
        package that is found: `mrt_add_library` is of mrt_cmake_modules, and no slip of `qt_add_library`.
        """
        if (of_family := self.of_family(name)) is not None:
            return of_family
        begin = name.partition("_")[0]
        if len(name) < SHORTEST or self.words.issuperset(name.split("_")) or begin in self.vendors:
            return None
        alike = (each for each in self.known if digits(each) == digits(name))
        return next(iter(near_names(name, alike, 1 if len(name) < SHORT else 2)), None)

    def of_family(self, name: str) -> str | None:
        """Return the one command of ROS that has the same words, but for their order or the last one."""
        words = name.split("_")
        family = [each for each in self.known if each.partition("_")[0] == words[0] and words[0] in RESERVED]
        same = [each for each in family if sorted(each.split("_")) == sorted(words)]
        start = f"{'_'.join(words[:-1])}_"
        begun = [each for each in family if each.startswith(start)] if len(words) > FEWEST else []
        near = same or begun
        return near[0] if len(near) == 1 else None

    @cached_property
    def vendors(self) -> frozenset[str]:
        """The first words of the packages that are found, but those of families whose commands are all known."""
        return frozenset(each.name.partition("_")[0] for each in self.cmake.packages).difference(RESERVED)

    @cached_property
    def known(self) -> frozenset[str]:
        return frozenset({*words("cmake_commands.txt"), *COMMANDS, *MAKERS, *self.cmake.functions})

    @cached_property
    def words(self) -> frozenset[str]:
        return frozenset(word for name in self.known for word in name.split("_"))


def is_one_slip(name: str, near: str) -> bool:
    """Return whether a name is that of a command but for one letter, or for the order of its words."""
    return distance(name, near, 1) <= 1 or near in same_words(name, [near])
