"""Commands in branches that nothing here takes: an option that is off, a switch that nothing sets, Windows."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from .branch_names import names_around
from .cmake_switches import FIXED, OF_OTHERS, OFF, CMakeSwitches

OTHER_SYSTEMS = frozenset({"WIN32", "MSVC", "MINGW", "APPLE", "ANDROID", "IOS"})

EQUALS = frozenset({"STREQUAL", "EQUAL", "MATCHES"})
ON = frozenset({"ON", "TRUE", "YES", "Y", "1"})
COMPARED = 2
"""Words that stand behind a name which is compared."""


@dataclass(frozen=True)
class SwitchedOff:
    cmake: CMake

    def has(self, call: EvaluatedCommand) -> bool:
        """Return whether a call is run only where a switch is on, and nothing here turns that on."""
        return call.maybe and any(map(self.is_off, self.asked.get(id(call.command), ())))

    def is_never_run(self, call: EvaluatedCommand) -> bool:
        """Return whether a call is in a branch that is never taken: `if(FALSE)`, or after a plain set()."""
        names = self.asked.get(id(call.command), ())
        return bool(names) and id(call.command) in self.closed and any(map(self.is_fixed, names))

    def is_fixed(self, name: str) -> bool:
        """Return whether a name is false wherever the package is built: a constant, or a variable set to one alone."""
        if name in OFF:
            return True
        calls = [call for call in self.cmake.calls if call.texts[:1] == (name,) and not OF_OTHERS.fullmatch(name)]
        return bool(calls) and all(call.name == "set" and call.texts[1:] in FIXED for call in calls)

    @cached_property
    def closed(self) -> frozenset[int]:
        """The commands in branches that are not taken."""
        taken = {id(call.command) for call in self.cmake.calls}
        return frozenset(id(call.command) for call in self.cmake.unreachable) - taken

    def is_off(self, name: str) -> bool:
        if name not in self.known:
            self.known[name] = name in OTHER_SYSTEMS or self.switches.is_left_off(name)
        return self.known[name]

    @cached_property
    def switches(self) -> CMakeSwitches:
        return CMakeSwitches(self.cmake)

    @cached_property
    def known(self) -> dict[str, bool]:
        return {}

    @cached_property
    def asked(self) -> dict[int, tuple[str, ...]]:
        """Command → the switches that must be on for the branches that it is in."""
        return names_around(self.cmake, switches_in)


def switches_in(texts: Sequence[str]) -> Iterator[str]:
    """Yield the names that must be on in a condition, alone or between AND: `if(WITH_CUDA AND ARM STREQUAL "ON")`."""
    parts: list[list[str]] = [[]]
    for text in texts:
        if text == "AND":
            parts.append([])
        else:
            parts[-1].append(text)
    for first, *rest in filter(None, parts):
        if not rest or (len(rest) == COMPARED and rest[0] in EQUALS and rest[1].upper() in ON):
            yield first.removeprefix("${").removesuffix("}")
