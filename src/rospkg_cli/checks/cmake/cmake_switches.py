"""Switches of a CMakeLists.txt (options, variables): whether a command, a page or a script turns one on."""

from __future__ import annotations

import re
from functools import cached_property

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.syntax import CommandInvocation
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ..repository.pages_and_scripts import pages_and_scripts
from .dead_branches import ASKING

SWITCH = regex(r"[A-Z][A-Z0-9]*(?:_[A-Z0-9]+)+")
"""What a package calls its switches: more than one word in capitals."""
OF_OTHERS = regex(r"CMAKE_\w+|\w+_FOUND|\w+_VERSION\w*|BUILD_TESTING|BUILD_SHARED_LIBS|ROS_\w+")
"""Names that look like switches, and that CMake, a package or the environment sets."""
OFF = frozenset({"OFF", "FALSE", "NO", "N", "0", ""})
FIXED = frozenset((each,) for each in OFF)
SETTERS = {"option": 2, "cmake_dependent_option": 2, "set": 1}
"""Where the value stands that a command gives a variable, which it names first."""
READING = frozenset({
    *ASKING, "add_compile_definitions", "add_compile_options", "add_definitions", "add_feature_info", "configure_file",
    "mark_as_advanced", "target_compile_definitions", "target_compile_options", "unset",
})  # fmt: skip
"""Commands that set no variable: what they name may be a macro of C++ that is called like a switch."""
NAME = regex(r"[A-Za-z]\w+")
READS = regex(r"\$\{[^{}]*\}|(?<!\w)-D\w+")
WORDS = regex(r"\w+")
PRESETS = ("colcon.pkg", "CMakePresets.json", "CMakeUserPresets.json")
"""Files of a package that hold arguments for its CMake."""
IS_OFF = regex(r"(?i)\b(?:off|false|disabled)\b|=0\b")
IS_ON = regex(r"(?i:=[ \t]*(?:on|true|1|yes)\b)|\bON\b")
OF_ROS1 = regex(r"\bcatkin")
"""What builds a workspace of ROS 1, of which the page was kept."""


@dataclass(frozen=True)
class CMakeSwitches:
    cmake: CMake

    def is_left_off(self, name: str) -> bool:
        """Return whether no command, page or script here turns a switch on."""
        return self.is_off_in_commands(name) and not self.is_on_in_pages(name)

    def is_off_in_commands(self, name: str) -> bool:
        """Return whether all commands that set a name are options that are off, or there is none.

        Where there is no option, what does not look like a switch may be set by a package that is found.
        """
        if not NAME.fullmatch(name) or OF_OTHERS.fullmatch(name) or self.cmake.reads_unknown_files:
            return False
        values = [call.texts[at : at + 1] for call, at in self.setting if call.texts[:1] == (name,)]
        is_known = bool(values) or SWITCH.fullmatch(name) is not None
        return is_known and all(value in ((), *FIXED) for value in values) and name not in self.named

    def is_on_in_pages(self, name: str) -> bool:
        """Return whether a page, a script or a workflow turns a switch on: a line has its name and not off."""
        lines = re.compile(rf"(?m)^.*(?:-D|(?<!\w)){name}(?!\w).*$")
        files = self.cmake.package_files
        own = (files.readable_text(path) for path in PRESETS if path in files.paths)
        texts = (text for text in (*pages_and_scripts(files), *own) if name in text)
        found = (line for text in texts for line in lines.findall(text))
        return any(IS_ON.search(line) or not IS_OFF.search(line) for line in found if not OF_ROS1.search(line))

    @cached_property
    def setting(self) -> list[tuple[EvaluatedCommand, int]]:
        """The commands that give the variable that they name first a value, and where that stands."""
        return [(call, SETTERS[call.name]) for call in self.cmake.named(*SETTERS)]

    @cached_property
    def named(self) -> frozenset[str]:
        """The words by which commands may set a variable, though not as SETTERS do: not `${A}`, nor a macro of C++."""
        commands = (each for file in self.cmake.files for each in file.syntax.commands if each.name not in READING)
        texts = (text for each in commands for text in given(each))
        return frozenset(word for text in texts for word in WORDS.findall(READS.sub("", text)))


def given(command: CommandInvocation) -> list[str]:
    """Return what a command is given that may name a variable: not the one that it sets, nor what it says of that."""
    texts = [each.text for each in command.arguments]
    if command.name == "set":
        return texts[1 : texts.index("CACHE") if "CACHE" in texts else None]
    return [] if command.name in SETTERS else texts
