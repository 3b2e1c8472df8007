"""Whole numbers for parameters that are doubles, written with a decimal point."""

from __future__ import annotations

from ..checks.params.mistyped_known import MistypedValue
from ..finding import Edit, Fix
from ..languages.yaml.nodes import ScalarNode, SequenceNode
from ..lazy_regex import regex
from ..package.params.parameter_file import Parameter
from ..source import Span

INTEGERS = (("int", "double"), ("int[]", "double[]"))
DECIMAL = regex(r"[+-]?(?:0|[1-9][0-9]*)")


def as_double(path: str, parameter: Parameter) -> Fix | None:
    """Put `.0` behind whole numbers that are written in decimal."""
    value = parameter.value
    items = value.items if isinstance(value, SequenceNode) else [value]
    numbers = [item for item in items if isinstance(item, ScalarNode) and DECIMAL.fullmatch(item.text)]
    if len(numbers) != len(items):
        return None
    edits = tuple(Edit(path, number.span, f"{number.text}.0") for number in numbers)
    return Fix("write it with `.0`", edits)


def known_as_double(each: MistypedValue) -> Fix | None:
    """Put `.0` behind whole numbers for a well-known node."""
    if each.value.written is not None:
        return as_double(each.path, each.value.written)
    place = Span(each.value.value.end, each.value.value.end)
    return Fix("write it with `.0`", (Edit(each.path, place, ".0"),)) if DECIMAL.fullmatch(each.value.text) else None
