"""Branches that ask whether a package was found (`if(X_FOUND)`) that nothing looks for: they are never taken."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.cmake.foreign_commands import foreign_commands
from ...ros.read_table import rows
from .branch_names import names_around

FOUND = regex(r"(\w+)_FOUND")
ASKING = ("if", "elseif", "else", "endif", "while", "message")
"""Commands that set nothing: what stands in them is not looked for."""
AUTOMATIC = ("ament_auto_find_build_dependencies", "ament_auto_find_test_dependencies")


@dataclass(frozen=True)
class DeadBranches:
    cmake: CMake

    def package_of(self, call: EvaluatedCommand) -> str:
        """Return a package without which a call is not run, and that no command looks for; "" where there is none."""
        if not call.maybe or not self.is_known:
            return ""
        return next((name for name in self.asked.get(id(call.command), ()) if not self.is_looked_for(name)), "")

    @cached_property
    def is_known(self) -> bool:
        """Whether all is read that may look for a package."""
        cmake = self.cmake
        is_open = bool(cmake.named(*AUTOMATIC)) or next(foreign_commands(cmake), None) is not None
        return cmake.is_complete and not cmake.reads_unknown_files and not is_open

    def is_looked_for(self, name: str) -> bool:
        """Return whether a command names a package, a part of its name (OpenMP_CXX), or what is set where it is found.

        What other packages are known to look for comes with them.
        """
        lower = name.lower()
        parts = {lower[:at] for at in range(1, len(lower) + 1) if lower[at : at + 1] in ("", "_")}
        brought = {
            each.lower() for found in self.cmake.packages for each in rows("cmake_exports.txt").get(found.name, ())
        }
        return not parts.isdisjoint(self.named | brought) or f"{lower}_found" in self.named

    @cached_property
    def named(self) -> frozenset[str]:
        """All words, in small letters, that commands are given that may look for a package or set a variable."""
        commands = (command for file in self.cmake.files for command in file.syntax.commands)
        given = (command for command in commands if command.name not in ASKING)
        words = (word for command in given for each in command.arguments for word in each.text.split(";"))
        evaluated = (text for call in self.cmake.calls if call.name not in ASKING for text in call.texts)
        return frozenset(word.lower() for word in (*words, *evaluated))

    @cached_property
    def asked(self) -> dict[int, tuple[str, ...]]:
        """Command → the packages that must be found for the branches that it is in."""
        return names_around(self.cmake, packages_in)


def packages_in(texts: Sequence[str]) -> Iterator[str]:
    """Yield the packages that a condition asks for."""
    for before, text in zip(["", *texts], texts, strict=False):
        found = FOUND.fullmatch(text) if before in ("", "AND") else None
        if found is not None:
            yield found[1]
