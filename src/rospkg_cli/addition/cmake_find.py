"""find_package() for a dependency."""

from __future__ import annotations

from collections.abc import Iterator

from ..change import ChangeError
from ..edits.cmake_commands import add_after, add_before, match_case, remove
from ..finding import Edit
from ..languages.cmake.command_blocks import Block
from ..languages.cmake.syntax import CommandInvocation
from ..light_dataclasses import dataclass
from ..package.cmake.cmake_facts import SEARCHES
from ..package.cmake.cmake_project import CMake
from ..package.package import Package
from .named import is_needed
from .part import Operations


@dataclass(frozen=True)
class FoundInCMake:
    """`find_package(NAME REQUIRED)` below the others."""

    name: str

    def add(self, package: Package) -> Operations:
        """Return the line, nothing where CMake looks for the package already, or for all dependencies."""
        cmake = cmake_of(package)
        found = [each for each in cmake.packages if each.name == self.name]
        if any(not (each.call.testing or each.call.maybe) for each in found):
            return ()
        root = cmake.root
        finders = [each for each in root.top if each.name == "find_package"]
        if cmake.named(*SEARCHES) or any(each.arguments and each.arguments[0].text == self.name for each in finders):
            return ()
        line = f"find_package({self.name} REQUIRED)"
        if finders:
            return (add_after(root, finders[-1], line),)
        first = first_after_project(cmake)
        return (add_before(root, first, f"{line}\n"),) if first else ()

    def remove(self, package: Package) -> Iterator[Operations]:
        """Yield the removal of the line, nothing where a file of the package needs it: Python finds no packages."""
        cmake = cmake_of(package)
        if is_needed(package, self.name, ".py"):
            return
        for command in reversed(cmake.root.top):
            texts = [argument.text for argument in command.arguments]
            if command.name == "find_package" and texts == [self.name, "REQUIRED"]:
                yield (remove(cmake.root, command),)
                line = match_case(cmake.root, f"find_package({self.name} REQUIRED)")
                start = command.span.start
                if cmake.root.source.text.startswith(f"{line}\n\n", start):
                    edit = remove(cmake.root, command)
                    yield (Edit(edit.path, type(edit.span)(edit.span.start, edit.span.end + 1), ""),)
                return


def cmake_of(package: Package) -> CMake:
    """Return the package's CMake; raises ChangeError where it can't be read."""
    cmake = package.parts(CMake).only
    if cmake is None:
        raise ChangeError("the package has no CMakeLists.txt that can be read; `rospkg lint` says why")
    return cmake


def first_after_project(cmake: CMake) -> CommandInvocation | None:
    """Return the first command below project() that is no setting: what needs packages comes after it."""
    seen = False
    for each in cmake.root.body:
        command = each.command if isinstance(each, Block) else each
        if seen and command.name not in ("set", "include", "cmake_policy", "option", "add_compile_options", "if"):
            return command
        seen = seen or command.name == "project"
    return None
