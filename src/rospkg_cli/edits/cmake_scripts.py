"""Edits that make an installed script executable."""

from __future__ import annotations

from ..checks.cmake.broken_scripts import BrokenScript
from ..checks.cmake.installed_scripts import InstalledScripts
from ..finding import Chmod, Edit, Operation
from ..package.cmake.cmake_project import CMake
from ..source import Span

SHEBANG = "#!/usr/bin/env python3\n"


def make_executable(scripts: InstalledScripts, script: BrokenScript) -> tuple[Operation, ...]:
    """Return the operations that make a script executable: PROGRAMS for FILES, a first line, or the executable bit."""
    cmake, copy = scripts.package.cmake, script.copy
    match script.wrong:
        case "files":
            return use_programs(cmake, scripts, script)
        case "no shebang":
            return (Edit(copy.source, Span(0, 0), SHEBANG),)
        case "directory":
            return add_source_permissions(cmake, script)
        case "neither":
            added = add_source_permissions(cmake, script)
            return (*added, Chmod(copy.source, True)) if added else ()
        case _:
            return (Chmod(copy.source, True),)


def use_programs(cmake: CMake, scripts: InstalledScripts, script: BrokenScript) -> tuple[Operation, ...]:
    """Write PROGRAMS where all that the rule installs are scripts."""
    call = script.copy.rule.call
    ours = [copy.source for copy in scripts.copies if copy.rule is script.copy.rule]
    if not all(scripts.script_files.has_shebang(path) for path in ours) or not call.command.arguments:
        return ()
    first = call.command.arguments[0]
    return (Edit(call.path, first.span, "PROGRAMS"),) if first.text == "FILES" else ()


def add_source_permissions(cmake: CMake, script: BrokenScript) -> tuple[Operation, ...]:
    """Add USE_SOURCE_PERMISSIONS behind the destination."""
    call = script.copy.rule.call
    arguments = call.command.arguments
    place = next((i for i, argument in enumerate(arguments[:-1]) if argument.text == "DESTINATION"), None)
    if place is None:
        return ()
    keyword, end = arguments[place], arguments[place + 1].span.end
    source = cmake.file(call.path).source
    line = source.line_span(source.position(keyword.span.start)[0])
    before = source.text[line.start : keyword.span.start]
    glue = " " if before.strip() else f"\n{before}"
    return (Edit(call.path, Span(end, end), f"{glue}USE_SOURCE_PERMISSIONS"),)
