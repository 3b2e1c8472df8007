"""Variables that nobody sets and that are one or two letters off one that CMake sets: they are empty."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.syntax import CommandArgument
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...source import Span
from ...suggest import near_names
from .mistyped_links import digits

SET_BY_CMAKE = frozenset("""
    PROJECT_NAME PROJECT_SOURCE_DIR PROJECT_BINARY_DIR PROJECT_VERSION CMAKE_PROJECT_NAME CMAKE_SOURCE_DIR
    CMAKE_BINARY_DIR CMAKE_CURRENT_SOURCE_DIR CMAKE_CURRENT_BINARY_DIR CMAKE_CURRENT_LIST_DIR CMAKE_CURRENT_LIST_FILE
    CMAKE_CURRENT_LIST_LINE CMAKE_INSTALL_PREFIX CMAKE_CXX_FLAGS CMAKE_C_FLAGS CMAKE_CXX_COMPILER_ID
    CMAKE_C_COMPILER_ID CMAKE_CXX_COMPILER CMAKE_C_COMPILER CMAKE_CXX_STANDARD CMAKE_C_STANDARD
    CMAKE_INSTALL_BINDIR CMAKE_INSTALL_SBINDIR CMAKE_INSTALL_LIBDIR CMAKE_INSTALL_LIBEXECDIR CMAKE_INSTALL_SYSCONFDIR
    CMAKE_INSTALL_INCLUDEDIR CMAKE_INSTALL_DATAROOTDIR CMAKE_INSTALL_DATADIR CMAKE_INSTALL_DOCDIR CMAKE_INSTALL_MANDIR
    CMAKE_INSTALL_INFODIR CMAKE_INSTALL_LOCALEDIR
""".split())  # fmt: skip
"""Those that packages use, and all of CMake 3.25 that are near to them."""

REFERENCE = regex(r"(?<!\\)\$\{([A-Za-z_]\w*)\}")
ANY_REFERENCE = regex(r"\$(?:ENV|CACHE)?\{[^{}]*\}")
NAME = regex(r"[A-Za-z_]\w*")


@dataclass(frozen=True)
class UnsetVariable:
    name: str
    near: str
    """The variable that is meant."""
    call: EvaluatedCommand
    span: Span
    before: str
    """The argument as it is written."""
    after: str
    """The argument without the variable."""


@dataclass(frozen=True)
class UnsetVariables:
    cmake: CMake

    def all(self) -> Iterator[UnsetVariable]:
        """Yield each place once; nothing where a file that can't be read may set any variable."""
        if self.cmake.reads_unknown_files:
            return
        seen: set[tuple[str, int]] = set()
        for call in self.cmake.calls:
            place = (call.path, call.command.span.start)
            if place not in seen and not call.maybe and call.name != "message":
                seen.add(place)
                for argument in call.command.arguments:
                    yield from self.within(call, argument)

    def within(self, call: EvaluatedCommand, argument: CommandArgument) -> Iterator[UnsetVariable]:
        if argument.kind == "bracket" or "${" not in argument.text:
            return
        for found in REFERENCE.finditer(argument.text):
            if near := self.nearest(found[1]):
                start = argument.inner.start
                span = Span(start + found.start(), start + found.end())
                after = argument.text.replace(found[0], "")
                yield UnsetVariable(found[1], near, call, span, argument.text, after)

    def nearest(self, name: str) -> str | None:
        """Return the variable that is meant by one that nothing sets."""
        if name in SET_BY_CMAKE or name in self.mentioned or name.startswith(self.prefixes):
            return None
        alike = (each for each in SET_BY_CMAKE if digits(each) == digits(name))
        return next(iter(near_names(name, alike)), None)

    @cached_property
    def mentioned(self) -> frozenset[str]:
        """All names in arguments outside of `${…}`: a command may set a variable of that name."""
        commands = (command for file in self.cmake.files for command in file.syntax.commands)
        texts = (argument.text for command in commands for argument in command.arguments)
        return frozenset(name for text in texts for name in NAME.findall(ANY_REFERENCE.sub(" ", text)))

    @cached_property
    def prefixes(self) -> tuple[str, ...]:
        """What the variables begin with that `cmake_parse_arguments` sets."""
        calls = self.cmake.named("cmake_parse_arguments")
        return tuple(f"{text}_" for call in calls for text in call.texts if NAME.fullmatch(text))
