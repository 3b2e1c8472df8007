"""What a CMake package may install that can't be evaluated: paths, and macros that may install anything."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...languages.cmake.evaluated_command import EvaluatedCommand, path_in_package
from ...languages.cmake.values import BINARY, Word
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...source import Span
from ...tree import LINKED
from ..install_table import InstalledFile, UnknownPart
from .ament_python_install import python_scripts
from .cmake_project import CMake
from .foreign_commands import commands_without_words, foreign_commands
from .install_kinds import ALL, InstallKinds
from .install_rule import InstallRule
from .set_variables import SetVariables

INSTALLS_ON_ITS_OWN = frozenset({"externalproject_add", "ament_vendor"})
"""Not FetchContent: the other project that it builds has a lib/ and a share folder of its own name."""
MAKES_PROGRAMS = regex(r"executable|program|install|node(?:s|let)?(?:_|$)")
"""Names of commands of other packages that may make programs: `agnocast_register_node`."""
MAKES_LIBRARIES = regex(r"_lib(?:rar(?:y|ies)|s)?(?:_|$)")
MAKES_HEADERS = regex(r"(?:\w+_)?(?:generate|make)_(?:\w+_)?headers?")
INSTALL_COMMANDS = frozenset({
    "ament_python_install_package", "ament_python_install_module", "catkin_install_python",
    "ament_get_python_install_dir", "ament_cmake_python_get_python_install_dir",
})  # fmt: skip
"""Commands whose effect is known, though their names have `install` in them."""


@dataclass(frozen=True)
class UnknownInstalls:
    cmake: CMake
    name: str
    """Of the package."""
    rows: tuple[InstalledFile, ...]
    """What the package certainly installs."""

    def all(self) -> Iterator[UnknownPart]:
        """Yield each part, with the reason and the place."""
        if not self.cmake.is_complete:
            for what in ALL:
                yield UnknownPart(what, self.cmake.stopped, self.cmake.root.path, Span(0, 0))
        for call in self.cmake.named("ament_python_install_package"):
            scripts = python_scripts(call, self.cmake.package_files)
            yield from (each for each in scripts if isinstance(each, UnknownPart))
        for rule in self.cmake.installs:
            yield from self.unknown_rule(rule)
        for call in self.cmake.calls:
            if self.may_install(call):
                for what in ALL[:2]:
                    yield UnknownPart(what, f"`{call.name}` may install anything", call.path, call.command.span)
        for call in (*foreign_commands(self.cmake), *commands_without_words(self.cmake)):
            if not (call.words and MAKES_HEADERS.fullmatch(call.name)):
                why = f"`{call.name}` of another package may install anything"
                yield UnknownPart("share", why, call.path, call.command.span, command=call.name)
                if self.may_make_programs(call):
                    yield UnknownPart("executable", why, call.path, call.command.span)

    def unknown_rule(self, rule: InstallRule) -> Iterator[UnknownPart]:
        """Yield what one rule may install, for each kind of file, where its items or its destination are unknown."""
        places = [rule.destination] if rule.kind != "TARGETS" else list((rule.destinations or {}).values())
        is_unclear = rule.kind == "CODE" or None in places
        items = [word for word in rule.items if not word.is_known and "$<TARGET_FILE" not in word.text]
        if rule.kind == "TARGETS":
            items = [word for word in items if self.variables.empty_variable(word) is None]
        if rule.kind == "DIRECTORY":
            items += [word for word in rule.items if lies_outside(word, rule.call.folder) or self.is_link(word, rule)]
        if not is_unclear and not items:
            return
        whats = {self.kinds.of(f"{place}/x") for place in places if place is not None} if not is_unclear else set(ALL)
        where = items[0] if items else rule.destination_word
        span = where.span if where is not None else rule.call.command.span
        is_made = (
            rule.kind != "TARGETS" and not is_unclear and all(is_foreign(each, rule.call.folder) for each in items)
        )
        below = (rule.destination or "").rstrip("/") if is_made else ""
        for what in sorted(whats):
            yield UnknownPart(what, self.why(where), where.path if where else rule.call.path, span, below)

    def why(self, word: Word | None) -> str:
        raw = " ".join(self.cmake.source_text(word).split()) if word is not None else ""
        return f"`{raw}` can't be evaluated" if raw else "what it installs can't be evaluated"

    def is_link(self, word: Word, rule: InstallRule) -> bool:
        """Return whether a folder is a link, which is not followed."""
        path = path_in_package(word.text, rule.call.folder) or ""
        return self.cmake.package_files.tree.files().get(path.rstrip("/")) in LINKED

    def may_make_programs(self, call: EvaluatedCommand) -> bool:
        """Return whether a macro of another package may make programs; without arguments its name says nothing."""
        if call.words and (MAKES_PROGRAMS.search(call.name) or "EXECUTABLE" in call.texts):
            return True
        return not self.has_programs and not (call.words and MAKES_LIBRARIES.search(call.name))

    @cached_property
    def variables(self) -> SetVariables:
        return SetVariables(self.cmake)

    @cached_property
    def kinds(self) -> InstallKinds:
        return InstallKinds(self.name, self.cmake.project_name)

    @cached_property
    def has_programs(self) -> bool:
        """Whether the package is seen to install programs: its others are probably made in the same way."""
        return any(target.is_executable for target in self.cmake.targets) or any(
            row.what == "executable" for row in self.rows
        )

    def may_install(self, call: EvaluatedCommand) -> bool:
        """Return whether a command may install anything, by its name."""
        known = call.name == "install" or call.name in INSTALL_COMMANDS or call.name in self.cmake.functions
        return call.name in INSTALLS_ON_ITS_OWN or ("install" in call.name and not known)


def lies_outside(word: Word, folder: str) -> bool:
    """Return whether a path leads out of the package or to the build folder: what is there is not looked at."""
    return word.is_known and path_in_package(word.text, folder) is None


def is_foreign(word: Word, folder: str) -> bool:
    """Return whether a path begins outside of the package's own files, however it goes on."""
    return word.text.startswith(f"{BINARY}/") or lies_outside(word, folder)
