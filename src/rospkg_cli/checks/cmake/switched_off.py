"""Commands in branches that nobody is shown to take: an option that is off, a switch that nothing sets, Windows."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from functools import cached_property

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ..pages_and_scripts import pages_and_scripts
from .branch_names import names_around
from .dead_branches import ASKING

OTHER_SYSTEMS = frozenset({"WIN32", "MSVC", "MINGW", "APPLE", "ANDROID", "IOS"})
SWITCH = regex(r"[A-Z][A-Z0-9]*(?:_[A-Z0-9]+)+")
"""What a package calls its switches: more than one word in capitals."""
OF_OTHERS = regex(r"CMAKE_\w+|\w+_FOUND|\w+_VERSION\w*|BUILD_TESTING|BUILD_SHARED_LIBS|ROS_\w+")
"""Names that look like switches, and that CMake, a package or the environment sets."""
OFF = frozenset({"OFF", "FALSE", "NO", "N", "0", ""})
FIXED = frozenset((each,) for each in OFF)
VALUE = 2
"""Where an option's value stands."""


@dataclass(frozen=True)
class SwitchedOff:
    cmake: CMake

    def has(self, call: EvaluatedCommand) -> bool:
        """Return whether a call is run only where somebody turns a switch on, and nothing here does so."""
        return call.maybe and any(map(self.is_off, self.asked.get(id(call.command), ())))

    def is_never_run(self, call: EvaluatedCommand) -> bool:
        """Return whether a call is in a branch that nobody can open: `if(FALSE)`, or after a plain set()."""
        names = self.asked.get(id(call.command), ())
        return bool(names) and id(call.command) in self.closed and any(map(self.is_fixed, names))

    def is_fixed(self, name: str) -> bool:
        """Return whether a name is false wherever the package is built: a constant, or a variable set to one alone."""
        if name in OFF:
            return True
        calls = [call for call in self.cmake.calls if call.texts[:1] == (name,)]
        return bool(calls) and all(call.name == "set" and call.texts[1:] in FIXED for call in calls)

    @cached_property
    def closed(self) -> frozenset[int]:
        """The commands in branches that are not taken."""
        taken = {id(call.command) for call in self.cmake.calls}
        return frozenset(id(call.command) for call in self.cmake.unreachable) - taken

    def is_off(self, name: str) -> bool:
        if name not in self.known:
            self.known[name] = name in OTHER_SYSTEMS or (self.is_turned_on_by_nobody(name) and not self.is_told(name))
        return self.known[name]

    def is_turned_on_by_nobody(self, name: str) -> bool:
        """Return whether all commands that have a name are options that are off, or there is none."""
        if not SWITCH.fullmatch(name) or OF_OTHERS.fullmatch(name) or self.cmake.reads_unknown_files:
            return False
        word = re.compile(rf"(?<!\w){name}(?!\w)")
        options = [call for call in self.cmake.named("option") if call.texts[:1] == (name,)]
        own = {id(call.command) for call in options}
        others = (each for file in self.cmake.files for each in file.syntax.commands if each.name not in ASKING)
        named = (argument.text for each in others if id(each) not in own for argument in each.arguments)
        is_on = any(call.texts[VALUE : VALUE + 1] not in ((), *((each,) for each in OFF)) for call in options)
        return not is_on and not any(map(word.search, named))

    def is_told(self, name: str) -> bool:
        """Return whether a page, a script or a workflow has the name: people are told to turn it on."""
        return any(name in text for text in pages_and_scripts(self.cmake.package_files))

    @cached_property
    def known(self) -> dict[str, bool]:
        return {}

    @cached_property
    def asked(self) -> dict[int, tuple[str, ...]]:
        """Command → the switches that must be on for the branches that it is in."""
        return names_around(self.cmake, switches_in)


def switches_in(texts: Sequence[str]) -> Iterator[str]:
    """Yield the names that stand alone in a condition, or between AND: `if(WITH_CUDA AND NOT QUIET)`."""
    for before, text, after in zip(["", *texts], texts, [*texts[1:], ""], strict=False):
        name = text.removeprefix("${").removesuffix("}")
        if before in ("", "AND") and after in ("", "AND"):
            yield name
