"""Definitions for generate_parameter_library: one YAML file a library, a tree of typed parameters.

Source: generate_parameter_library_py/parse_yaml.py, cpp_conversions.py and the tables of its README.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from dataclasses import dataclass

from ...files import ReaderInput
from ...languages.cmake.evaluated_command import path_in_package
from ...languages.yaml.nodes import MappingNode, ScalarNode, SequenceNode, YamlNode, documents
from ...source import Source, Span
from ...suggest import did_you_mean
from ...unreadable import Unreadable, UnreadableError
from ..cmake.cmake_project import CMake
from ..python_modules import Modules
from .declared import DeclaredParameter
from .file import Fault
from .value import FALSE, TRUE, yaml_type

COMMANDS = ("generate_parameter_library", "generate_parameter_module")
FIELDS = frozenset({"default_value", "description", "read_only", "additional_constraints", "validation", "type"})
BASES = {"bool": "bool", "double": "double", "int": "int", "string": "string"}
FIXED = re.compile(r"(?P<base>(?:double|int|string)_array|string)_fixed_[0-9]+")
VALIDATORS = frozenset(
    """bounds lt gt lt_eq gt_eq one_of fixed_size size_gt size_lt not_empty unique subset_of element_bounds
    lower_element_bounds upper_element_bounds lower_bounds upper_bounds""".split()
)
YAML_BOOLS = (TRUE | FALSE) - frozenset("yYnN")
MAP = "__map_"


@dataclass(frozen=True, slots=True)
class Definition:
    """One parameter: its keys without the first, and what stands below the last."""

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
    definitions: tuple[Definition, ...]
    faults: tuple[Fault, ...]

    @property
    def path(self) -> str:
        return self.source.path


def read_parameter_libraries(reading: ReaderInput) -> Iterator[ParameterLibrary | Unreadable]:
    """Read the definitions that CMakeLists.txt or setup.py hands to the generator."""
    for path, custom in dict(library_files(reading)).items():
        if reading.files.exists(path):
            try:
                source = reading.files.source(path)
                yield library(source, documents(source), custom)
            except UnreadableError as error:
                yield error.unreadable


def library_files(reading: ReaderInput) -> Iterator[tuple[str, bool]]:
    """Yield each file of definitions, and whether a header with validators is given beside it."""
    cmake = reading.parts(CMake).only
    for call in cmake.named(*COMMANDS) if cmake else ():
        if len(call.words) > 1 and (path := path_in_package(call.words[1].text, call.folder)):
            yield path, len(call.words) > 2
    modules = reading.parts(Modules).only
    setup = modules.at("setup.py") if modules else None
    for node in ast.walk(setup.tree) if setup else ():
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == COMMANDS[1]:
            words = [each.value if isinstance(each, ast.Constant) else None for each in node.args]
            if len(words) > 1 and isinstance(words[1], str):
                yield words[1], len(words) > 2


def library(source: Source, roots: list[YamlNode], custom: bool) -> ParameterLibrary:
    root = roots[0] if roots else None
    if not isinstance(root, MappingNode) or len(root.entries) != 1:
        message = "a file of parameter definitions has one key at its top: the name of the namespace"
        span = root.entries[1][0].span if isinstance(root, MappingNode) and len(root.entries) > 1 else Span(0, 0)
        return ParameterLibrary(source, (), (Fault("yaml", span, f"{message}; the build stops"),))
    definitions = tuple(leaves(root.entries[0][1], (), None))
    faults = [fault for each in definitions for fault in judge(each, custom)]
    return ParameterLibrary(source, definitions, tuple(faults))


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


def judge(each: Definition, custom: bool) -> Iterator[Fault]:
    kind, found = each.type, each.field("type")
    name = ".".join(each.keys)
    if found is None:
        yield Fault("yaml", each.key.span, f"`{name}` has no `type`; the build stops")
        return
    for key, _ in each.fields.entries:
        if isinstance(key, ScalarNode) and key.text not in FIELDS:
            hint = did_you_mean(key.text, FIELDS)
            yield Fault("yaml", key.span, f"`{key.text}` is no field of a parameter{hint}; the build stops")
    base = base_of(kind)
    if base is None:
        known = [*BASES, *(f"{each}_array" for each in BASES), "none"]
        yield Fault(
            "yaml", found.span, f"`{kind}` is no type of a parameter{did_you_mean(kind, known)}; the build stops"
        )
    default = each.field("default_value") if base not in (None, "none") else None
    if base and default is not None and (fault := default_fault(base, default)):
        yield Fault("yaml", default.span, f"the default of `{name}` {fault}; the build stops")
    validation = each.field("validation")
    for key, _ in validation.entries if isinstance(validation, MappingNode) else ():
        if isinstance(key, ScalarNode):
            yield from validator(key, custom)


def base_of(kind: str) -> str | None:
    """Return a type without its fixed size; None where there is no such type."""
    if fixed := FIXED.fullmatch(kind):
        kind = fixed.group("base")
    return kind if kind.removesuffix("_array") in BASES or kind == "none" else None


def validator(key: ScalarNode, custom: bool) -> Iterator[Fault]:
    name = key.text.removesuffix("<>")
    hint = did_you_mean(name, VALIDATORS)
    if name not in VALIDATORS and "::" not in name and (hint or not custom):
        message = f"`{key.text}` is no validator{hint}: the generated code does not compile"
        yield Fault("yaml", key.span, f"{message}; one of your own is written `namespace::function`")


def default_fault(base: str, value: YamlNode) -> str | None:
    """Return why a default does not fit, as PyYAML reads it: an int will do for a double."""
    inside = base.removesuffix("_array")
    if inside != base:
        if isinstance(value, SequenceNode):
            wrong = next((item for item in value.items if not fits(inside, item)), None)
            return f"holds `{shown(wrong)}`, which is no `{inside}`" if wrong is not None else None
        return f"is no list, and its type is `{base}`" if not is_null(value) else None
    return None if fits(base, value) or is_null(value) else f"is `{shown(value)}`, which is no `{base}`"


def is_null(value: YamlNode) -> bool:
    return isinstance(value, ScalarNode) and value.plain and value.text in ("", "~", "null", "Null", "NULL")


def fits(base: str, value: YamlNode) -> bool:
    if not isinstance(value, ScalarNode):
        return False
    text = value.text
    plain = value.plain and value.tag is None
    if base == "string":
        return not plain or (yaml_type(text) == "string" and text not in YAML_BOOLS)
    if base == "bool":
        return plain and text in YAML_BOOLS
    kind = yaml_type(text) if plain else "string"
    return kind == "int" or (kind == "double" and base == "double")


def shown(value: YamlNode | None) -> str:
    return value.text if isinstance(value, ScalarNode) else "…"


def defined_parameters(reading: ReaderInput) -> Iterator[DeclaredParameter]:
    """Yield what the definitions of a package declare."""
    for library in reading.parts(ParameterLibrary).good:
        for each in library.definitions:
            maps = [place for place, key in enumerate(each.keys) if key.startswith(MAP)]
            keys = each.keys[maps[-1] + 1 :] if maps else each.keys
            base = base_of(each.type) or ""
            kind = base.replace("_array", "[]") if base != "none" else ""
            required = each.field("default_value") is None and not maps and base != "none"
            yield DeclaredParameter(".".join(keys), bool(maps), kind, required, library.path)
