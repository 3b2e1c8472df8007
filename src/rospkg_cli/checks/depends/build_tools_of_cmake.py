"""Tools that CMake runs, or whose variables it reads, and that package.xml does not declare (DEP114)."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.file import CMakeFile
from ...lazy_regex import regex
from ...light_dataclasses import dataclass, replace
from ...package.cmake.cmake_project import CMake
from ...ros.distros import Targets
from ...source import Span
from .declared_dependencies import DeclaredDependencies

CLONED_BY = {"GIT_REPOSITORY": "git", "HG_REPOSITORY": "mercurial", "SVN_REPOSITORY": "subversion"}
"""The keywords of CMake's ExternalProject and FetchContent, and the rosdep keys of the programs that clone."""

FETCHES = ("externalproject_add", "fetchcontent_declare")
RUNS = ("add_custom_command", "add_custom_target")
PROGRAMS = {each: each for each in ("curl", "git", "unzip", "wget")} | {"hg": "mercurial", "svn": "subversion"}
"""Programs that fetch or unpack what is built, and that no build tool of ROS brings, with their rosdep keys."""
ASKS_PKG_CONFIG = ("pkg_check_modules", "pkg_search_module")
PKG_CONFIG, ENVIRONMENT = "pkg-config", "ros_environment"
ERRORS = ("FATAL_ERROR", "SEND_ERROR", "ERROR")
"""The modes of message() that are intended to stop CMake; ERROR is not one of CMake's, but common."""
ITSELF = "cmake"
"""The build type that no build tool of ROS comes with, and the rosdep key of what it needs."""
VARIABLE = regex(r"\$ENV\{(ROS_DISTRO|ROS_VERSION|ROS_PYTHON_VERSION)\}")
"""The variables that the package ros_environment sets where it is installed."""


@dataclass(frozen=True, slots=True)
class BuildTool:
    name: str
    """The rosdep key, or the package."""
    what: str
    """The command, or the variable, that needs it."""
    tag: str
    path: str
    span: Span
    bringer: str = ""
    """The declared dependency with which it comes on some distributions."""


@dataclass(frozen=True)
class BuildToolsOfCMake:
    declared: DeclaredDependencies
    cmake: CMake

    def missing(self) -> Iterator[BuildTool]:
        """Yield each tool once, where it is used first, unless it is declared or certainly comes with what is."""
        seen: set[str] = set()
        there = self.declared.brings.brought_to_build
        for tool in self.used() if self.declared.is_checked else ():
            is_there = tool.name in there.certain and tool.name != ITSELF
            if tool.name not in seen and not self.declared.has([tool.name]) and not is_there:
                yield replace(tool, bringer=there.perhaps.get(tool.name, ""))
            seen.add(tool.name)

    def used(self) -> Iterator[BuildTool]:
        yield from self.cmake_itself()
        for call in self.cmake.calls:
            for name in self.needed_by(call):
                tag = "test_depend" if call.testing else "buildtool_depend"
                yield BuildTool(name, call.name, tag, call.path, call.command.name_span)
        for file in self.cmake.files:
            yield from self.read_in(file)

    def cmake_itself(self) -> Iterator[BuildTool]:
        """Yield the tool of a plain CMake package, unless a tool of ament that it declares brings it."""
        manifest = self.declared.manifest
        tools = {each.name for each in manifest.dependencies if each.tag != "test_depend"}
        for element in manifest.build_types(Targets()):
            if element.text.strip() == ITSELF and not any(name.startswith("ament_cmake") for name in tools):
                what = f"<build_type>{ITSELF}</build_type>"
                yield BuildTool(ITSELF, what, "buildtool_depend", manifest.path, element.span)

    def needed_by(self, call: EvaluatedCommand) -> Iterator[str]:
        """Yield what a command fails without, wherever it runs."""
        if call.name in FETCHES:
            yield from (CLONED_BY[word.text] for word in call.words if word.text in CLONED_BY)
        elif call.name in ASKS_PKG_CONFIG and "REQUIRED" in call.texts:
            yield PKG_CONFIG
        else:
            yield from (PROGRAMS[each] for each in programs_of(call) if each in PROGRAMS)

    def read_in(self, file: CMakeFile) -> Iterator[BuildTool]:
        """Yield the first variable of ros_environment that a file reads and never asks for (`if(DEFINED ENV{…})`).

        Where its absence is an error, it is needed all the same.
        """
        asked: set[str] = set()
        read: list[BuildTool] = []
        errors = " ".join(said_as_error(file))
        for command in file.syntax.commands:
            for argument in command.arguments:
                asked.add(argument.text)
                for variable in VARIABLE.findall(argument.text):
                    read.append(BuildTool(ENVIRONMENT, variable, "build_depend", file.path, argument.span))
        yield from (each for each in read if f"ENV{{{each.what}}}" not in asked or each.what in errors)


def programs_of(call: EvaluatedCommand) -> list[str]:
    """Return the programs that a command of CMake needs, so that CMake or the build stops without them."""
    texts = call.texts
    stops = "COMMAND_ERROR_IS_FATAL" in texts if call.name == "execute_process" else call.name in RUNS
    if stops and "||" not in texts:
        return [after for before, after in pairwise(texts) if before == "COMMAND"]
    return list(texts[1:2]) if call.name == "find_program" and "REQUIRED" in texts else []


def said_as_error(file: CMakeFile) -> Iterator[str]:
    """Yield the messages of a file that stop CMake and print the value of no variable."""
    for command in file.syntax.commands:
        texts = [argument.text for argument in command.arguments]
        if command.name == "message" and texts and texts[0] in ERRORS and not any("$" in each for each in texts):
            yield from texts[1:]
