"""Which variable was intended where CMakeLists.txt reads one that nothing sets."""

from __future__ import annotations

from functools import cached_property

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.file import assigned_names
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.cmake.set_variables import SetVariables
from ...package.workspace import Workspace
from ...suggest import near_names
from .given_variables import given_variables
from .name_slips import digits
from .package_variables import PackageVariables
from .set_by_cmake import SET_BY_CMAKE, near_variable_of_cmake

PROJECT = "PROJECT_NAME"
SHORTEST = 6
"""Letters that a name needs for a similar one to be a slip of it; from twice as many on, two letters may be wrong."""
FEW_WORDS = 2
"""Words of a name that many names have."""


@dataclass(frozen=True)
class IntendedVariables:
    cmake: CMake
    workspace: Workspace

    def in_call(self, name: str, call: EvaluatedCommand) -> str | None:
        """Return the variable that a command should read instead of `name`; None where it is set, or none is near.

        Where a file can't be read, which may set any variable, only slips of PROJECT_NAME count; in a command that may
        not be run, only slips of variables of CMake.
        """
        if self.cmake.reads_unknown_files:
            is_slip = name not in self.variables.mentioned and bool(near_names(name, [PROJECT]))
            return PROJECT if is_slip else None
        found = self.of_cmake(name) if call.maybe else self.nearest(name)
        return found or (self.with_lost_word(name) if call.name == "install" and not call.maybe else None)

    def nearest(self, name: str) -> str | None:
        """Return the variable of CMake, of a found package or of the package itself that is near an unset one."""
        if name in SET_BY_CMAKE or self.variables.may_be_set(name):
            return None
        if found := near_variable_of_cmake(name):
            return found
        return None if name in self.given else self.of_packages.near(name) or self.near_own(name)

    def of_cmake(self, name: str) -> str | None:
        """Return the variable of CMake that is near an unset one."""
        is_set = name in SET_BY_CMAKE or self.variables.may_be_set(name)
        return None if is_set else near_variable_of_cmake(name)

    def near_own(self, name: str) -> str | None:
        """Return the variable that the package itself sets and that is near `name`, which nothing else may set.

        It may differ in upper and lower case alone, which CMake distinguishes.
        """
        if len(name) < SHORTEST or not self.variables.is_own(name):
            return None
        same = [each for each in self.assigned if each.lower() == name.lower()]
        if len(same) == 1:
            return same[0]
        alike = (each for each in self.assigned if digits(each) == digits(name))
        return next(iter(near_names(name, alike, 1 if len(name) < 2 * SHORTEST else 2)), None)

    def with_lost_word(self, name: str) -> str | None:
        """Return the one variable of the package whose name has a word more or less: `A_B_C` for `A_B_C_FILES`."""
        if self.variables.may_be_set(name) or not self.variables.is_own(name):
            return None
        words = name.strip("_").split("_")
        others = [(each, each.strip("_").split("_")) for each in self.assigned]
        alike = [each for each, whole in others if lacks_one(words, whole) or lacks_one(whole, words)]
        return alike[0] if len(alike) == 1 and len(words) > FEW_WORDS else None

    @cached_property
    def given(self) -> frozenset[str]:
        """The variables that a user may give with -D or in the environment: they may be empty on purpose."""
        return frozenset(given_variables(self.cmake.calls, self.cmake.files))

    @cached_property
    def assigned(self) -> frozenset[str]:
        """The variables that the package's own CMake files set."""
        return frozenset(name for file in self.cmake.files for name in assigned_names(file))

    @cached_property
    def variables(self) -> SetVariables:
        return SetVariables(self.cmake)

    @cached_property
    def of_packages(self) -> PackageVariables:
        return PackageVariables(self.cmake, self.workspace)


def lacks_one(words: list[str], whole: list[str]) -> bool:
    """Return whether `words` are all words of `whole` but one, in the same order."""
    return len(whole) == len(words) + 1 and any(whole[:n] + whole[n + 1 :] == words for n in range(len(whole)))
