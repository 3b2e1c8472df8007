"""Unset variables in the commands of targets, where a variable that differs by one word is set and never read."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cached_property

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from .intended_variables import FEW_WORDS, lacks_one
from .unset_variable import UnsetVariable
from .unset_variables import OF_TARGETS, REFERENCE, UnsetVariables

WHOLE = regex(r"\$\{([A-Za-z_]\w*)\}")
NESTED = regex(r"\$\{((?:\w|\$\{\w+\})+)\}")
"""A variable whose name may have the value of another one in it: `${${name}_SOURCES}`."""


@dataclass(frozen=True)
class UnreadTwins:
    unset: UnsetVariables

    def all(self) -> Iterator[UnsetVariable]:
        """Yield each place, also where a file can't be read: what is set here is intended to be read."""
        for call in self.unset.cmake.named(*OF_TARGETS):
            for argument in call.command.arguments[1:] if not call.maybe and not call.function else ():
                name = WHOLE.fullmatch(argument.text) if argument.kind != "bracket" else None
                twin = self.twin_of(name[1]) if name is not None else None
                if name is not None and twin is not None:
                    yield UnsetVariable(name[1], twin, call, argument.inner, name[0], "")

    def twin_of(self, name: str) -> str | None:
        """Return the one variable that is set, read nowhere, and has a word more or less than an unset one."""
        variables, words = self.unset.intended.variables, name.split("_")
        if name in variables.mentioned or name.startswith(variables.prefixes) or not variables.is_own(name):
            return None
        unread = [(each, each.split("_")) for each in self.unset.intended.assigned - self.read]
        alike = [each for each, whole in unread if lacks_one(words, whole) or lacks_one(whole, words)]
        is_one = len(alike) == 1 and len(words) > FEW_WORDS and not self.unset.intended.near_own(name)
        return alike[0] if is_one and not self.may_be_made_up(alike[0]) else None

    def may_be_made_up(self, name: str) -> bool:
        """Return whether an argument may read a variable by a name that has the value of another one in it."""
        names = {found[1] for text in self.texts for found in NESTED.finditer(text) if "$" in found[1]}
        return any(re.fullmatch(REFERENCE.sub(r"\\w*", each), name) for each in names)

    @cached_property
    def read(self) -> frozenset[str]:
        """The variables that any argument reads."""
        return frozenset(name for text in self.texts for name in REFERENCE.findall(text))

    @cached_property
    def texts(self) -> tuple[str, ...]:
        """All arguments of the package's files that read a variable."""
        commands = (command for file in self.unset.cmake.files for command in file.syntax.commands)
        return tuple(each.text for command in commands for each in command.arguments if "${" in each.text)
