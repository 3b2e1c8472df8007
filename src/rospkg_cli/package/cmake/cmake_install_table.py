"""The install table of a package that CMake builds."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator
from functools import cached_property

from ...languages.cmake.evaluated_command import EvaluatedCommand, path_in_package
from ...languages.cmake.values import BINARY, UNKNOWN, Word
from ...lazy_regex import regex
from ...light_dataclasses import replace
from ...source import Span
from ...tree import LINKED
from ..install_table import PYTHON, InstalledFile, InstallKind, InstallTable, UnknownPart
from .ament_python_install import python_scripts
from .artifacts import Artifacts
from .cmake_project import CMake
from .copied_files import copied_files
from .foreign_commands import commands_without_words, foreign_commands
from .install_rules import InstallRule
from .macro_installs import PACKAGE, installed_by_macros
from .set_variables import SetVariables

INSTALLS_ON_ITS_OWN = frozenset({"externalproject_add", "ament_vendor"})
"""Not FetchContent: the other project that it builds has a lib/ and a share folder of its own name."""
MAKES_PROGRAMS = regex(r"executable|program|install|node(?:s|let)?(?:_|$)")
"""Names of commands of other packages that may make programs: `agnocast_register_node`."""
MAKES_LIBRARIES = regex(r"_lib(?:rar(?:y|ies)|s)?(?:_|$)")
MAKES_HEADERS = regex(r"(?:\w+_)?(?:generate|make)_(?:\w+_)?headers?")


def cmake_table(cmake: CMake, name: str) -> InstallTable:
    """Return what the package called `name` installs; what ament writes itself (hooks, configs) is left out."""
    table = CMakeTableBuilder(cmake, name)
    rows = tuple(dict.fromkeys(table.rows()))
    return InstallTable(rows, tuple(table.unknown()))


class CMakeTableBuilder:
    def __init__(self, cmake: CMake, name: str) -> None:
        self.cmake = cmake
        self.name = name
        self.artifacts = Artifacts(cmake)
        self.variables = SetVariables(cmake)

    def rows(self) -> Iterator[InstalledFile]:
        if ends := self.cmake.named(*PACKAGE):
            manifest = InstalledFile("share", f"share/{self.name}/package.xml", "package.xml", "", "package.xml")
            yield replace(manifest, maybe=all(call.maybe for call in ends))
        for rule in self.cmake.installs:
            if rule.kind == "TARGETS":
                yield from self.targets(rule)
            else:
                yield from self.files(rule)
        yield from self.automatic()
        yield from (self.row(*made) for made in installed_by_macros(self.cmake, self.name))
        yield from (each for each in self.python_scripts() if isinstance(each, InstalledFile))

    def row(self, destination: str, source: str, word: Word, *calls: EvaluatedCommand) -> InstalledFile:
        """Return the row of an argument; `calls` must all be run for it to be installed."""
        maybe, testing = word.maybe or any(call.maybe for call in calls), any(call.testing for call in calls)
        return InstalledFile(self.what(destination), destination, source, "", word.path, word.span, maybe, testing)

    def what(self, destination: str) -> InstallKind:
        if destination.startswith((f"lib/{self.name}/", f"lib/{self.cmake.project_name}/", "bin/")):
            return "executable"
        for prefix, what in PLACES:
            if destination.startswith(prefix):
                return what
        return "other"

    def files(self, rule: InstallRule) -> Iterator[InstalledFile]:
        for copy in copied_files(rule, self.cmake.package_files):
            yield self.row(copy.destination, copy.source, copy.item, rule.call)
        if rule.kind in ("FILES", "PROGRAMS") and rule.destination is not None:
            for word in (each for each in rule.items if lies_outside(each, rule.call.folder)):
                name = rule.rename.text if rule.rename else posixpath.basename(word.text)
                yield self.row(posixpath.normpath(posixpath.join(rule.destination, name)), "", word, rule.call)

    def targets(self, rule: InstallRule) -> Iterator[InstalledFile]:
        for word in rule.items:
            target = self.cmake.target(word.text)
            if target is None and word.is_known and (missing := self.missing_executable(rule, word)):
                yield missing
            place = self.artifacts.destination(rule, target) if target is not None and target.is_built else None
            if target is not None and place is not None:
                path = posixpath.join(place, self.artifacts.file_name(target))
                row = self.row(path, "", word, rule.call, target.call)
                yield replace(row, what="executable") if target.is_executable and place == "lib" else row

    def missing_executable(self, rule: InstallRule, word: Word) -> InstalledFile | None:
        """Return the row of a target that nothing makes, so that only this is told, and not also who starts it."""
        destinations = rule.destinations or {}
        place = destinations.get("RUNTIME", destinations.get(""))
        return self.row(f"{place}/{word.text}", "", word, rule.call) if place == f"lib/{self.name}" else None

    def automatic(self) -> Iterator[InstalledFile]:
        """What ament_auto_package installs of itself: the targets of ament_auto_add_*, and include/."""
        for call in self.cmake.named("ament_auto_package", "autoware_ament_auto_package")[:1]:
            place = "bin" if "INSTALL_TO_PATH" in call.texts else f"lib/{self.name}"
            for target in self.cmake.targets:
                if target.call.name == "ament_auto_add_executable" and UNKNOWN not in target.name:
                    yield self.row(f"{place}/{self.artifacts.file_name(target)}", "", target.word, target.call)
                elif target.call.name == "ament_auto_add_library" and target.is_built and UNKNOWN not in target.name:
                    yield self.row(f"lib/{self.artifacts.file_name(target)}", "", target.word, target.call)
            scope = f"include/{self.name}" if "USE_SCOPED_HEADER_INSTALL_DIR" in call.texts else "include"
            for path in self.cmake.package_files.below("include"):
                place = posixpath.join(scope, path.removeprefix("include/"))
                yield InstalledFile("header", place, path, "", call.path, call.command.name_span)

    def python_scripts(self) -> Iterator[InstalledFile | UnknownPart]:
        for call in self.cmake.named("ament_python_install_package"):
            yield from python_scripts(call, self.cmake.package_files)

    # ---- what is unknown

    def unknown(self) -> Iterator[UnknownPart]:
        if not self.cmake.is_complete:
            for what in ALL:
                yield UnknownPart(what, self.cmake.stopped, self.cmake.root.path, Span(0, 0))
        yield from (each for each in self.python_scripts() if isinstance(each, UnknownPart))
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
        places = [rule.destination] if rule.kind != "TARGETS" else list((rule.destinations or {}).values())
        is_unclear = rule.kind == "CODE" or None in places
        items = [word for word in rule.items if not word.is_known and "$<TARGET_FILE" not in word.text]
        if rule.kind == "TARGETS":
            items = [word for word in items if self.variables.empty_variable(word) is None]
        if rule.kind == "DIRECTORY":
            items += [word for word in rule.items if lies_outside(word, rule.call.folder) or self.is_link(word, rule)]
        if not is_unclear and not items:
            return
        whats = {self.what(f"{place}/x") for place in places if place is not None} if not is_unclear else set(ALL)
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
        """Return whether a folder is a link, behind which we do not look."""
        path = path_in_package(word.text, rule.call.folder) or ""
        return self.cmake.package_files.tree.files().get(path.rstrip("/")) in LINKED

    def may_make_programs(self, call: EvaluatedCommand) -> bool:
        """Return whether a macro of another package may: what is given nothing has no name that tells otherwise."""
        if call.words and (MAKES_PROGRAMS.search(call.name) or "EXECUTABLE" in call.texts):
            return True
        return not self.has_programs and not (call.words and MAKES_LIBRARIES.search(call.name))

    @cached_property
    def has_programs(self) -> bool:
        """Whether the package is seen to install programs: its others are probably made in the same way."""
        return any(target.is_executable for target in self.cmake.targets) or any(
            row.what == "executable" for row in self.rows()
        )

    def may_install(self, call: EvaluatedCommand) -> bool:
        known = call.name == "install" or call.name in INSTALL_COMMANDS or call.name in self.cmake.functions
        return call.name in INSTALLS_ON_ITS_OWN or ("install" in call.name and not known)


def lies_outside(word: Word, folder: str) -> bool:
    """Return whether a path leads out of the package or to the build folder: what is there is not looked at."""
    return word.is_known and path_in_package(word.text, folder) is None


def is_foreign(word: Word, folder: str) -> bool:
    """Return whether a path begins outside of the package's own files, however it goes on."""
    return word.text.startswith(f"{BINARY}/") or lies_outside(word, folder)


ALL: tuple[InstallKind, ...] = ("executable", "share", "module", "library", "header", "other")
PLACES: tuple[tuple[str, InstallKind], ...] = (
    ("share/", "share"),
    (PYTHON + "/", "module"),
    ("include/", "header"),
    ("lib/", "library"),
)
INSTALL_COMMANDS = frozenset({
    "ament_python_install_package", "ament_python_install_module", "catkin_install_python",
    "ament_get_python_install_dir", "ament_cmake_python_get_python_install_dir",
})  # fmt: skip
