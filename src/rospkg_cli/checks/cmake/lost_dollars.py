"""References to variables that CMake takes for plain text: their dollar sign or a brace is lost."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.file import assigned_names
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...source import Span
from .lost_values import LostValues
from .set_by_cmake import SET_BY_CMAKE

LOST = regex(
    r"(?<![\w$@{\\])\{\$?([A-Za-z_]\w*)\}(?!\})"  # {NAME} and {$NAME}
    r"|(?<![\\$])\$\(([A-Za-z_]\w*)\)"  # $(NAME)
    r"|(?<![\\$\w{])\$([A-Za-z_]\w*)(?![\w{])"  # $NAME
)
OTHER_LANGUAGES = frozenset(
    """
    message string file add_custom_command add_custom_target execute_process if elseif while cmake_language
    function macro configure_file exec_program add_test ament_add_test set_tests_properties
    """.split()
)
"""Commands whose arguments are texts, patterns, or what a shell, Make or an environment gets."""
OF_LOADER = frozenset({"ORIGIN", "LIB", "PLATFORM"})
"""What the loader itself puts into an RPATH: `$ORIGIN/../$LIB`."""
OF_INSTALL = frozenset({"CODE", "SCRIPT"})
EXPORTS = "ament_export_"
SHORTEST = 3
"""Letters of a variable of the package's own that is reported."""


@dataclass(frozen=True)
class LostDollar:
    call: EvaluatedCommand
    span: Span
    text: str
    name: str

    has_effect: bool = True
    """Whether what the command is given goes anywhere."""
    why_not: str = ""
    """Why nothing is lost: the end of a sentence."""

    @property
    def sentence(self) -> str:
        start = f"`{self.text}` is no variable but plain text, which CMake leaves as it is"
        return f"{start}; write `${{{self.name}}}`{'; ' if self.why_not else ''}{self.why_not}"


@dataclass(frozen=True)
class LostDollars:
    cmake: CMake

    def all(self) -> Iterator[LostDollar]:
        """Yield each place once."""
        seen: set[tuple[str, int]] = set()
        for call in self.cmake.calls:
            place = (call.path, call.command.span.start)
            if place not in seen and not self.is_of_others(call):
                seen.add(place)
                yield from self.within(call)

    def is_of_others(self, call: EvaluatedCommand) -> bool:
        """Return whether what a command is given is for another language."""
        return call.name in OTHER_LANGUAGES or (call.name == "install" and not OF_INSTALL.isdisjoint(call.texts))

    def has_effect(self, call: EvaluatedCommand) -> bool:
        """Return whether anything is lost by a command: what is exported has to reach `ament_package()` of its folder.

        Targets that `ament_auto_package()` installs as well are found all the same, and no target is a dead line.
        """
        if call.name == "install" and call.texts[:1] == ("TARGETS",):
            return call.texts[1:2] != ("DESTINATION",) and not any(self.cmake.named("ament_auto_package"))
        folders = {each.folder for each in self.cmake.named("ament_package", "ament_auto_package")}
        return not call.name.startswith(EXPORTS) or not folders or call.folder in folders

    def within(self, call: EvaluatedCommand) -> Iterator[LostDollar]:
        for argument in call.command.arguments:
            for found in LOST.finditer(argument.text) if argument.kind != "bracket" else ():
                name = found[1] or found[2] or found[3]
                if name in self.names:
                    start = argument.inner.start
                    place = Span(start + found.start(), start + found.end())
                    why_not = self.values.why_not(call, name, argument.text[found.end() :])
                    yield LostDollar(call, place, found[0], name, self.has_effect(call) and not why_not, why_not)

    @cached_property
    def values(self) -> LostValues:
        return LostValues(self.cmake)

    @cached_property
    def names(self) -> frozenset[str]:
        """The variables of CMake that packages use, and those that the package sets."""
        own = (name for file in self.cmake.files for name in assigned_names(file))
        return SET_BY_CMAKE | {name for name in own if len(name) >= SHORTEST and name not in OF_LOADER}
