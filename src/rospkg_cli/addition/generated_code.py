"""What makes code of the definitions of a node's parameters: it is taken out with the node, `add` never puts it in."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ..edits.cmake_commands import remove, start_with_comments
from ..finding import Edit
from ..light_dataclasses import dataclass
from ..package.package import Package
from ..scaffold.requested_node import RequestedNode
from ..source import Span
from .cmake_find import FoundInCMake, cmake_of
from .dependency import AddedDependency
from .part import Operations, Part

COMMANDS = ("generate_parameter_library", "generate_parameter_module")
CALL = "    generate_parameter_module("
BLOCK = re.compile(
    r"^if len\(sys\.argv\) >= 2 and sys\.argv\[1\] != 'clean':\n"
    r"    from generate_parameter_library_py\.setup_helper import generate_parameter_module\n\n",
    re.MULTILINE,
)
SYS = re.compile(r"^(?<!\n\n)import sys\n|^import sys\n\n", re.MULTILINE)
"""The line, with the blank one behind it where it is the only line between two."""


def generated_by_cmake(node: RequestedNode) -> Iterator[Part]:
    """Yield what CMake has for a node with definitions."""
    if node.definitions:
        yield AddedDependency("generate_parameter_library")
        yield FoundInCMake("generate_parameter_library")
        yield GeneratedByCMake(node.definitions)


@dataclass(frozen=True)
class GeneratorDeclared:
    """The generator among what setup.py needs, in a group of its own in package.xml."""

    def add(self, package: Package) -> Operations:
        """Return nothing: it comes and goes with the code of setup.py."""
        return ()

    def remove(self, package: Package) -> Iterator[Operations]:
        """Yield the removal of the element, with the blank line behind it where another one is before it."""
        declared = AddedDependency("generate_parameter_library_py", tag="build_depend")
        for edits in declared.remove(package):
            text = package.files.readable_text("package.xml")
            for edit in edits:
                assert isinstance(edit, Edit)
                start, end = edit.span.start, edit.span.end
                is_between = text.endswith("\n\n", 0, start) and text.startswith("\n", end)
                yield (Edit(edit.path, Span(start, end + is_between), ""),)


@dataclass(frozen=True)
class GeneratedByCMake:
    """`generate_parameter_library(NAME …)` or `generate_parameter_module(NAME …)`."""

    name: str

    def add(self, package: Package) -> Operations:
        """Return nothing: `add` writes nodes that declare their parameters themselves."""
        return ()

    def remove(self, package: Package) -> Iterator[Operations]:
        """Yield the removal of the command, with the comment and the blank line where it is the last one."""
        root = cmake_of(package).root
        commands = [each for each in root.top if each.name in COMMANDS and each.arguments]
        for command in commands:
            if command.arguments[0].text == self.name:
                edit = remove(root, command)
                if len(commands) > 1:
                    yield (edit,)
                    continue
                blank = root.source.text.startswith("\n", edit.span.end)
                start = min(edit.span.start, start_with_comments(root.source, command))
                yield (Edit(edit.path, Span(start, edit.span.end + blank), ""),)


@dataclass(frozen=True)
class GeneratedBySetup:
    """`generate_parameter_module('NAME', …)` in setup.py."""

    name: str

    def add(self, package: Package) -> Operations:
        """Return nothing, as that of CMake."""
        return ()

    def remove(self, package: Package) -> Iterator[Operations]:
        """Yield the removal of the call, with what all of them need where it is the last one."""
        text = package.files.readable_text("setup.py")
        call = re.search(rf"^{re.escape(CALL)}\s*'{self.name}',[^()]*\)\n", text, re.MULTILINE)
        if call:
            spans = [Span(*call.span())] if text.count(CALL) > 1 else all_of_it(text, call)
            yield tuple(Edit("setup.py", span, "") for span in spans)


def all_of_it(text: str, call: re.Match[str]) -> list[Span]:
    """Return the spans of the block around the only call, and of the import that only it needs."""
    block = BLOCK.search(text)
    if block is None or block.end() != call.start():
        return [Span(*call.span())]
    end = call.end() + text.startswith("\n", call.end())
    rest = text[: block.start()] + text[end:]
    found = SYS.search(text) if len(re.findall(r"\bsys\b", rest)) == 1 else None
    return [*([Span(*found.span())] if found else []), Span(block.start(), end)]


@dataclass(frozen=True)
class IgnoredModule:
    """The line of .gitignore for a module that a build with links makes in the source folder."""

    path: str

    def add(self, package: Package) -> Operations:
        """Return nothing: it comes and goes with what makes the module."""
        return ()

    def remove(self, package: Package) -> Iterator[Operations]:
        """Yield the removal of the line."""
        text = package.files.readable_text(".gitignore") if package.files.exists(".gitignore") else ""
        for line in re.finditer(rf"^/{re.escape(self.path)}\n", text, re.MULTILINE):
            yield (Edit(".gitignore", Span(*line.span()), ""),)
