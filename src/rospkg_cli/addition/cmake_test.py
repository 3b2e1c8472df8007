"""A test in CMakeLists.txt: in the block of the tests, or in a new one."""

from __future__ import annotations

from collections.abc import Iterator

from ..change import NotUnderstoodError, Paste
from ..edits.cmake_commands import match_case
from ..finding import Edit
from ..languages.cmake.command_blocks import Block
from ..languages.cmake.file import CMakeFile
from ..light_dataclasses import dataclass
from ..package.cmake.cmake_project import CMake
from ..package.package import Package
from ..source import Span
from .cmake_block import block_removals
from .cmake_find import cmake_of
from .part import Operations


@dataclass(frozen=True)
class CMakeTest:
    name: str
    path: str
    includes: str = ""
    """The folder that the test finds its headers in; "" where it needs none."""

    @property
    def target(self) -> str:
        return f"test_{self.name}_py" if self.path.endswith(".py") else f"test_{self.name}"

    def add(self, package: Package) -> Operations:
        """Return the edit, nothing where a command names the file; raises NotUnderstoodError."""
        cmake = cmake_of(package)
        if any(text.endswith(self.path) for call in cmake.calls for text in call.texts):
            return ()
        root = cmake.root
        tests = block_of_tests(root)
        if tests is not None and tests.end is not None:
            line = root.source.line_span(root.source.position(tests.end.span.start)[0])
            lines = indented(match_case(root, self.lines(root, cmake)), root.indent)
            return (Edit(root.path, Span(line.start, line.start), lines + "\n"),)
        lines = whole(root, self.lines(root, cmake))
        if root.end is None:
            raise NotUnderstoodError(
                "CMakeLists.txt has no ament_package() at its end: put the lines where the tests are, and run the "
                "command again",
                Paste("CMakeLists.txt", lines),
            )
        at = root.source.line_span(root.source.position(root.end.span.start)[0]).start
        return (Edit(root.path, Span(at, at), f"{match_case(root, lines)}\n\n"),)

    def lines(self, root: CMakeFile, cmake: CMake) -> str:
        """Return the commands, with the search for what defines them where nothing does that yet."""
        finder, command = ("ament_cmake_gtest", "ament_add_gtest")
        if self.path.endswith(".py"):
            finder, command = ("ament_cmake_pytest", "ament_add_pytest_test")
        before = [each for each in cmake.packages if each.name == finder]
        found = [] if before and not self.is_finder_ours(cmake, command) else [f"find_package({finder} REQUIRED)"]
        lines = [*found, f"{command}({self.target} {self.path})"]
        if self.includes:
            lines.append(f"target_include_directories({self.target} PRIVATE {self.includes})")
        return "\n".join(lines)

    def is_finder_ours(self, cmake: CMake, command: str) -> bool:
        """Return whether no other test uses what defines the command, so that it goes with this one."""
        calls = cmake.named(command)
        return bool(calls) and all(any(text.endswith(self.path) for text in call.texts) for call in calls)

    def remove(self, package: Package) -> Iterator[Operations]:
        """Yield the removal of a block of its own, else of the lines in a block of several tests."""
        cmake = cmake_of(package)
        root = cmake.root
        lines = self.lines(root, cmake)
        shorter = "\n".join(line for line in lines.split("\n") if not line.startswith("find_package"))
        for each in (lines, shorter):
            yield from block_removals(root, whole(root, each))
        for each in (lines, shorter):
            yield from block_removals(root, indented(each, root.indent))


def whole(root: CMakeFile, lines: str) -> str:
    """Return a block of tests of its own."""
    return f"if(BUILD_TESTING)\n{indented(lines, root.indent)}\nendif()"


def block_of_tests(file: CMakeFile) -> Block | None:
    """Return the last `if(BUILD_TESTING)` outside of other blocks that has no other branch."""
    found = None
    for each in file.body:
        if isinstance(each, Block) and [a.text for a in each.command.arguments] == ["BUILD_TESTING"]:
            found = each if len(each.branches) == 1 else found
    return found


def indented(lines: str, indent: str) -> str:
    return "\n".join(f"{indent}{line}" for line in lines.split("\n"))
