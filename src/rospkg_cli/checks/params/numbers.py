"""Numbers that one reader of parameter files takes for a number and another for a text."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass

from ...languages.yaml.nodes import ScalarNode, SequenceNode, YamlNode
from ...package.params.file import ParameterFile
from ...package.params.value import integer, type_of, yaml_type
from ...source import Span

EXPONENT = re.compile(r"([+-]?)([0-9]*)(?:\.([0-9]*))?[eE]([+-]?)([0-9]+)")
OCTAL = re.compile(r"[+-]?0[0-9]+")


@dataclass(frozen=True, slots=True)
class AmbiguousNumber:
    span: Span
    message: str
    repairs: tuple[tuple[Span, str], ...] = ()
    right_for_rcl: bool = False


def ambiguous_numbers(file: ParameterFile) -> Iterator[AmbiguousNumber]:
    """Yield them in order; of one list only the first, with the repairs of all."""
    for block in file.blocks:
        for parameter in block.parameters:
            found = [number for scalar in scalars(parameter.value) for number in judge(scalar)]
            if found:
                first = found[0]
                repairs = tuple(repair for number in found for repair in number.repairs)
                more = f" ({len(found)} times in this list)" if len(found) > 1 else ""
                yield AmbiguousNumber(first.span, first.message + more, repairs, all(n.right_for_rcl for n in found))


def scalars(value: YamlNode) -> Iterator[ScalarNode]:
    for item in value.items if isinstance(value, SequenceNode) else [value]:
        if isinstance(item, ScalarNode) and item.plain and item.tag is None:
            yield item


def judge(scalar: ScalarNode) -> Iterator[AmbiguousNumber]:
    text, rcl, yaml = scalar.text, type_of(scalar), yaml_type(scalar.text)
    if rcl == "double" and yaml == "string" and not OCTAL.fullmatch(text):
        better = canonical(text)
        hint = f": write `{better}`" if better else ""
        message = f"`{text}` is a number for rcl, but a text for PyYAML, which launch files read it with"
        yield AmbiguousNumber(scalar.span, message + hint, ((scalar.span, better),) if better else (), True)
    elif rcl == "string" and yaml != "string":
        better = text.replace("_", "") if re.fullmatch(r"[-+]?[0-9_.eE+-]+", text) else None
        hint = f": write `{better}`" if better else "; quote it, so that it is one for PyYAML too"
        message = f"`{text}` is a text for rcl, and a number for PyYAML{hint}"
        yield AmbiguousNumber(scalar.span, message, ((scalar.span, better),) if better else (), better is None)
    elif OCTAL.fullmatch(text) and rcl != "string":
        meant = text.lstrip("+-0") or "0"
        shown = f"octal, that is {integer(text)}" if rcl == "int" else "no whole number any more"
        yield AmbiguousNumber(scalar.span, f"`{text}` is {shown}, because of the zero before it: write `{meant}`")


def canonical(text: str) -> str | None:
    """Return the number as both readers take it: `1e-9` as `1.0e-9`."""
    if text.lower() in ("nan", "inf", "+inf", "-inf"):
        return f"{text[:-3]}.{text[-3:].lower()}"
    found = EXPONENT.fullmatch(text)
    if found is None:
        return None
    sign, whole, part, direction, power = found.groups()
    return f"{sign}{whole or '0'}.{part or '0'}e{direction or '+'}{power}"
