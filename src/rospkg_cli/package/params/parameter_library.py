"""Definitions for generate_parameter_library: one YAML file a library, a tree of typed parameters.

Source: generate_parameter_library_py/parse_yaml.py, cpp_conversions.py and the tables of its README.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator

from ...files import PackageFiles, ReaderInput
from ...languages.cmake.evaluated_command import path_in_package
from ...languages.python.nodes import nodes_of
from ...languages.yaml.nodes import MappingNode, ScalarNode, YamlNode, documents
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...source import Source
from ...unreadable import Unreadable, UnreadableError
from ..cmake.cmake_project import CMake
from ..python_modules import PythonModules
from .declared_parameter import DeclaredParameter

COMMANDS = ("generate_parameter_library", "generate_parameter_module")
BASES = {"bool": "bool", "double": "double", "int": "int", "string": "string"}
FIXED = regex(r"(?P<base>(?:double|int|string)_array|string)_fixed_[0-9]+")
MAP = "__map_"


@dataclass(frozen=True, slots=True)
class Definition:
    """One parameter: its keys without the first, and the fields below the last."""

    keys: tuple[str, ...]
    key: ScalarNode
    fields: MappingNode

    def field(self, name: str) -> YamlNode | None:
        return next((v for k, v in self.fields.entries if isinstance(k, ScalarNode) and k.text == name), None)

    @property
    def type(self) -> str:
        found = self.field("type")
        return found.text if isinstance(found, ScalarNode) else ""


@dataclass(frozen=True)
class ParameterLibrary:
    source: Source
    root: YamlNode | None
    """A mapping with one key, the namespace; anything else is refused, and defines nothing."""
    definitions: tuple[Definition, ...]
    has_validators: bool
    """Whether a header with validators of the package's own is passed with it."""

    @property
    def path(self) -> str:
        return self.source.path


def read_parameter_libraries(reading: ReaderInput) -> Iterator[ParameterLibrary | Unreadable]:
    """Read the definitions that CMakeLists.txt or setup.py passes to the generator."""
    for path, has_validators in dict(library_files(reading)).items():
        if reading.files.exists(path):
            try:
                source = reading.files.source(path)
                yield library(source, documents(source), has_validators)
            except UnreadableError as error:
                yield error.unreadable


def library_files(reading: ReaderInput) -> Iterator[tuple[str, bool]]:
    """Yield each file of definitions, and whether a header with validators is passed with it."""
    cmake = reading.parts(CMake).only if may_generate(reading.files) else None
    for call in cmake.named(*COMMANDS) if cmake else ():
        if len(call.words) > 1 and (path := path_in_package(call.words[1].text, call.folder)):
            yield path, len(call.words) > 2
    modules = reading.parts(PythonModules).only
    setup = modules.at("setup.py") if modules else None
    for node in nodes_of(setup.tree) if setup else ():
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == COMMANDS[1]:
            words = [each.value if isinstance(each, ast.Constant) else None for each in node.args]
            if len(words) > 1 and isinstance(words[1], str):
                yield words[1], len(words) > 2


def may_generate(files: PackageFiles) -> bool:
    """Return whether a CMake file may call the generator: few neighbours have to be evaluated for it."""
    for path in files.paths:
        if path.endswith(("CMakeLists.txt", ".cmake")):
            try:
                text = files.source(path).text.lower()
            except UnreadableError:
                return True
            if any(each in text for each in (*COMMANDS, "cmake_language")):
                return True
    return False


def library(source: Source, roots: list[YamlNode], has_validators: bool) -> ParameterLibrary:
    root = roots[0] if roots else None
    is_one = isinstance(root, MappingNode) and len(root.entries) == 1
    definitions = tuple(leaves(root.entries[0][1], (), None)) if isinstance(root, MappingNode) and is_one else ()
    return ParameterLibrary(source, root, definitions, has_validators)


def leaves(node: YamlNode, keys: tuple[str, ...], key: ScalarNode | None) -> Iterator[Definition]:
    """Yield the parameters: mappings whose first value is none."""
    if not isinstance(node, MappingNode) or not node.entries:
        return
    if isinstance(node.entries[0][1], MappingNode):
        for each, value in node.entries:
            if isinstance(each, ScalarNode):
                yield from leaves(value, (*keys, each.text), each)
    elif key is not None:
        yield Definition(keys, key, node)


def base_of(kind: str) -> str | None:
    """Return a type without its fixed size; None where there is no such type."""
    if fixed := FIXED.fullmatch(kind):
        kind = fixed.group("base")
    return kind if kind.removesuffix("_array") in BASES or kind == "none" else None


def defined_parameters(reading: ReaderInput) -> Iterator[DeclaredParameter]:
    """Yield what the definitions of a package declare."""
    for library in reading.parts(ParameterLibrary).good:
        for each in library.definitions:
            maps = [place for place, key in enumerate(each.keys) if key.startswith(MAP)]
            keys = each.keys[maps[-1] + 1 :] if maps else each.keys
            base = base_of(each.type) or ""
            kind = base.replace("_array", "[]") if base != "none" else ""
            value = each.field("default_value")
            required = value is None and not maps and base != "none"
            default = value.text if isinstance(value, ScalarNode) else ""
            yield DeclaredParameter(".".join(keys), bool(maps), kind, required, library.path, default)
