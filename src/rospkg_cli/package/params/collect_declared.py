"""All parameters that a package's code declares."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache

from ...files import ReaderInput
from ...languages.cpp.file import read_cpp
from ...languages.cpp.read import SUFFIXES
from ...lazy_regex import regex
from ...source import Source
from ...unreadable import UnreadableError
from ..file_role import role_of
from ..python_modules import PythonModules
from . import python_parameters as python
from .declared_parameter import DeclaredParameter
from .parameter_file import ParameterFile
from .parameter_library import defined_parameters

DECLARES = regex("declare_parameter|declare_or_get_parameter|declareParameter")
DYNAMIC = "dynamic_typing"
"""Where a descriptor allows this, a parameter takes values of any type."""


def declared_parameters(reading: ReaderInput) -> tuple[DeclaredParameter, ...]:
    """Return what a package declares, in C++, in Python, and for generate_parameter_library; each once."""
    found = [*in_cpp(reading), *in_python(reading), *defined_parameters(reading)]
    return tuple(dict.fromkeys(found))


def in_cpp(reading: ReaderInput) -> Iterator[DeclaredParameter]:
    sources = [source for path in reading.files.paths if path.endswith(SUFFIXES) for source in text_of(reading, path)]
    declaring = [read_cpp(source) for source in sources if DECLARES.search(source.text)]
    if not declaring:
        return
    from . import cpp_parameters as cpp  # what packages in Python don't need
    from .cpp_parameter_types import variables_of

    asked = {name for file in declaring for name in cpp.asked_variables(file)}
    types = variables_of(sources, asked)
    for file in declaring:
        loose = DYNAMIC in file.source.text
        for each in cpp.declared_in(file, lambda name: types.get(name, "")):
            yield untyped(each) if loose else each


def in_python(reading: ReaderInput) -> Iterator[DeclaredParameter]:
    modules = reading.parts(PythonModules).only
    paths = [path for path in reading.files.paths if path.endswith(".py") and role_of(path) == "run"] if modules else []

    @cache
    def constant(name: str) -> str:
        """Return the type of a constant that modules or their classes bind to values of one type."""
        return next(iter(constants().get(name, ()))) if len(constants().get(name, ())) == 1 else ""

    @cache
    def constants() -> dict[str, set[str]]:
        found: dict[str, set[str]] = {}
        for file in (modules.at(path) for path in paths) if modules else ():
            for name, kind in python.constants_in(file) if file else ():
                found.setdefault(name, set()).add(kind)
        return found

    for path in paths:
        for source in text_of(reading, path):
            if "declare_parameter" in source.text and modules and (file := modules.at(path)):
                found = python.declared_in(file, constant)
                yield from (map(untyped, found) if DYNAMIC in source.text else found)


def given_parameters(reading: ReaderInput) -> tuple[frozenset[str], ...]:
    """Return the names that each block of the package's parameter files gives."""
    blocks = (block for file in reading.parts(ParameterFile).good for block in file.blocks)
    return tuple(frozenset(each.name for each in block.parameters) for block in blocks)


def untyped(each: DeclaredParameter) -> DeclaredParameter:
    return DeclaredParameter(each.name, each.tail, "", each.required, each.path)


def text_of(reading: ReaderInput, path: str) -> Iterator[Source]:
    if role_of(path) not in ("test", "aside"):
        try:
            yield reading.files.source(path)
        except UnreadableError:
            return
