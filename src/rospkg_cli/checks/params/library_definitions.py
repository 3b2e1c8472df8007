"""PRM009: definitions for generate_parameter_library that the generator refuses.

Source: generate_parameter_library_py/parse_yaml.py, cpp_conversions.py and the tables of its README.
"""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.yaml.nodes import MappingNode, ScalarNode, SequenceNode, YamlNode
from ...package.params.parameter_library import BASES, Definition, ParameterLibrary, base_of
from ...package.params.scalar_types import FALSE, TRUE, yaml_type
from ...source import Span
from ...suggest import did_you_mean
from ..fault import Fault

FIELDS = frozenset({"default_value", "description", "read_only", "additional_constraints", "validation", "type"})
VALIDATORS = frozenset(
    """bounds lt gt lt_eq gt_eq one_of fixed_size size_gt size_lt not_empty unique subset_of element_bounds
    lower_element_bounds upper_element_bounds lower_bounds upper_bounds""".split()
)
ARGUMENTS = {
    **dict.fromkeys(("bounds", "element_bounds"), 2),
    **dict.fromkeys(("lt", "gt", "lt_eq", "gt_eq", "fixed_size", "size_gt", "size_lt", "one_of", "subset_of"), 1),
    **dict.fromkeys(("lower_element_bounds", "upper_element_bounds"), 1),
    **dict.fromkeys(("not_empty", "unique"), 0),
}
"""How many arguments a validator takes; `LISTS` take one that is a list."""
LISTS = frozenset({"one_of", "subset_of"})
YAML_BOOLS = (TRUE | FALSE) - frozenset("yYnN")


def library_faults(library: ParameterLibrary) -> Iterator[Fault]:
    root = library.root
    if not isinstance(root, MappingNode) or len(root.entries) != 1:
        message = "a file of parameter definitions has one key at its top, the name of the namespace: the build stops"
        span = root.entries[1][0].span if isinstance(root, MappingNode) and len(root.entries) > 1 else Span(0, 0)
        yield Fault(span, f"{message}; put all below one")
    for each in library.definitions:
        yield from definition_faults(each, library.has_validators)


def definition_faults(each: Definition, has_validators: bool) -> Iterator[Fault]:
    kind, found = each.type, each.field("type")
    name = ".".join(each.keys)
    if found is None:
        yield Fault(each.key.span, f"`{name}` has no `type`: the build stops; add one")
        return
    for key, _ in each.fields.entries:
        if isinstance(key, ScalarNode) and key.text not in FIELDS:
            hint = did_you_mean(key.text, FIELDS)
            yield Fault(
                key.span, f"`{key.text}` is no field of a parameter{hint}: the build stops; correct or remove it"
            )
    base = base_of(kind)
    if base is None:
        known = [*BASES, *(f"{each}_array" for each in BASES), "none"]
        message = f"`{kind}` is no type of a parameter{did_you_mean(kind, known)}: the build stops"
        yield Fault(found.span, f"{message}; write `{'`, `'.join(BASES)}` or one with `_array`")
    default = each.field("default_value") if base not in (None, "none") else None
    if base and default is not None and (problem := default_problem(base, default)):
        yield Fault(default.span, f"the default of `{name}` {problem}: the build stops; correct it, or the type")
    validation = each.field("validation")
    for key, given in validation.entries if isinstance(validation, MappingNode) else ():
        if isinstance(key, ScalarNode):
            yield from validator_faults(key, has_validators)
            yield from argument_faults(key, given)


def validator_faults(key: ScalarNode, has_validators: bool) -> Iterator[Fault]:
    name = key.text.removesuffix("<>")
    hint = did_you_mean(name, VALIDATORS)
    if name not in VALIDATORS and "::" not in name and (hint or not has_validators):
        message = f"`{key.text}` is no validator{hint}: the generated code does not compile"
        yield Fault(key.span, f"{message}; one of your own is written `namespace::function`")


def argument_faults(key: ScalarNode, given: YamlNode) -> Iterator[Fault]:
    """Yield why the arguments of a validator do not fit; one that is no list is the only one."""
    name = key.text.removesuffix("<>")
    wanted = ARGUMENTS.get(name)
    if wanted is None:
        return
    count = len(given.items) if isinstance(given, SequenceNode) else 0 if is_null(given) else 1
    if name in LISTS and isinstance(given, SequenceNode) and all(isinstance(item, ScalarNode) for item in given.items):
        message = f"`{key.text}` takes one list: the generated code does not compile"
        yield Fault(key.span, f"{message}; write a second pair of brackets, `[[…]]`")
    elif count != wanted:
        message = f"`{key.text}` takes {wanted or 'no'} argument{'s' * (wanted != 1)}, not {count}"
        yield Fault(key.span, f"{message}: the generated code does not compile")


def default_problem(base: str, value: YamlNode) -> str | None:
    """Return why a default does not fit, as PyYAML reads it: an int will do for a double."""
    inside = base.removesuffix("_array")
    if inside != base:
        if isinstance(value, SequenceNode):
            wrong = next((item for item in value.items if not fits(inside, item)), None)
            return f"holds `{text_of(wrong)}`, which is no `{inside}`" if wrong is not None else None
        return f"is no list, and its type is `{base}`" if not is_null(value) else None
    return None if fits(base, value) or is_null(value) else f"is `{text_of(value)}`, which is no `{base}`"


def is_null(value: YamlNode) -> bool:
    return isinstance(value, ScalarNode) and value.is_plain and value.text in ("", "~", "null", "Null", "NULL")


def fits(base: str, value: YamlNode) -> bool:
    if not isinstance(value, ScalarNode):
        return False
    text = value.text
    plain = value.is_plain and value.tag is None
    if base == "string":
        return not plain or (yaml_type(text) == "string" and text not in YAML_BOOLS)
    if base == "bool":
        return plain and text in YAML_BOOLS
    kind = yaml_type(text) if plain else "string"
    return kind == "int" or (kind == "double" and base == "double")


def text_of(value: YamlNode | None) -> str:
    return value.text if isinstance(value, ScalarNode) else "…"
