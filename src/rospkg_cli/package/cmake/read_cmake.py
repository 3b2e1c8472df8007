"""Evaluate the CMake files of a package."""

from __future__ import annotations

from collections.abc import Iterator

from ...files import ReaderInput
from ...languages.cmake.file import CMakeFile
from ...unreadable import Unreadable
from ..manifest import Manifest
from .build import is_built_with_cmake
from .cmake_project import CMake


def read_cmake_files(reading: ReaderInput) -> Iterator[CMakeFile | Unreadable]:
    """Yield every CMake file that is read, one by one."""
    yield from reading.parts(CMake).broken
    for cmake in reading.parts(CMake).good:
        yield from cmake.files


def read_cmake(reading: ReaderInput) -> Iterator[CMake | Unreadable]:
    """Yield the package's CMake, or one Unreadable for each of its files that can't be read."""
    if not is_built_with_cmake(reading):
        return
    # Two dozen modules that other packages need not import
    from ...languages.cmake.commands import COMMANDS
    from ...languages.cmake.control_flow import BLOCKS
    from ...languages.cmake.functions import call_function
    from ...languages.cmake.interpreter import Interpreter
    from ...languages.cmake.output_variables import run_unknown_command

    interpreter = Interpreter(
        reading.files,
        commands=COMMANDS,
        blocks=BLOCKS,
        invoke=call_function,
        run_unknown_command=run_unknown_command,
        own_name=own_name(reading),
    )
    interpreter.run()
    if interpreter.broken:
        yield from interpreter.broken
    else:
        yield CMake(
            reading.files,
            tuple(interpreter.read.values()),
            tuple(interpreter.calls),
            tuple(interpreter.unreachable),
            interpreter.stopped,
            interpreter.reads_unknown_files,
            interpreter.includes_unknown_files,
            own_name(reading),
        )


def own_name(reading: ReaderInput) -> str:
    """Return the package's name, which a macro may read out of package.xml for project(): it has to be the same."""
    manifest = reading.parts(Manifest).only
    return manifest.name if manifest is not None else ""
