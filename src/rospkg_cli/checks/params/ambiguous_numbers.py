"""PRM005: numbers that one reader of parameter files takes for a number and another for a string."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...languages.yaml.nodes import ScalarNode, SequenceNode, YamlNode
from ...lazy_regex import regex
from ...package.params.parameter_file import NodeBlock, ParameterFile
from ...package.params.scalar_types import integer, type_of, yaml_type
from ..fault import Fault, TextRepair, replacement

EXPONENT = regex(r"([+-]?)([0-9]*)(?:\.([0-9]*))?[eE]([+-]?)([0-9]+)")
OCTAL = regex(r"[+-]?0[0-9]+")


def number_faults(file: ParameterFile, *, is_read_by_python: bool) -> Iterator[Fault]:
    """Yield the faults in order; of one list only the first, with the repairs of all.

    What rcl reads as intended is an info where nothing else reads the file.
    """
    for block in file.blocks:
        yield from block_faults(block, is_read_by_python=is_read_by_python)


def block_faults(block: NodeBlock, *, is_read_by_python: bool) -> Iterator[Fault]:
    """Yield the same of the parameters of one node."""
    for parameter in block.parameters:
        found = [fault for each in plain_scalars(parameter.value) if (fault := number_fault(each))]
        if found:
            edits = tuple(edit for fault in found if fault.repair for edit in fault.repair.edits)
            more = f" ({len(found)} times in this list)" if len(found) > 1 else ""
            is_info = all(fault.level for fault in found) and not is_read_by_python
            yield Fault(
                found[0].span,
                found[0].message + more,
                "info" if is_info else None,
                TextRepair(f"write `{edits[0][1]}`", edits) if edits else None,
            )


def plain_scalars(value: YamlNode) -> Iterator[ScalarNode]:
    for item in value.items if isinstance(value, SequenceNode) else [value]:
        if isinstance(item, ScalarNode) and item.is_plain and item.tag is None:
            yield item


def number_fault(scalar: ScalarNode) -> Fault | None:
    """Return the fault of a scalar that rcl and PyYAML read differently; an info where rcl is right."""
    text, rcl, yaml = scalar.text, type_of(scalar), yaml_type(scalar.text)
    if rcl == "double" and yaml == "string" and not OCTAL.fullmatch(text):
        better = canonical(text)
        hint = f": write `{better}`" if better else ""
        message = f"`{text}` is a number for rcl, but a string for PyYAML, which launch files read it with"
        return Fault(scalar.span, message + hint, "info", replacement(scalar.span, better) if better else None)
    if rcl == "string" and yaml != "string":
        if not re.fullmatch(r"[-+]?[0-9_.eE+-]+", text):
            hint = "quote it, so that it is a string for PyYAML too"
            return Fault(scalar.span, f"`{text}` is a string for rcl, and a number for PyYAML; {hint}", "info")
        better = text.replace("_", "")
        message = f"`{text}` is a string for rcl, and a number for PyYAML: write `{better}`"
        return Fault(scalar.span, message, None, replacement(scalar.span, better))
    if OCTAL.fullmatch(text) and not (rcl == "int" and integer(text) == int(text)):
        decimal = ("-" if text[0] == "-" else "") + (text.lstrip("+-0") or "0")
        shown = f"octal, that is {integer(text)}" if rcl == "int" else "not a whole number"
        return Fault(scalar.span, f"`{text}` is {shown}, because of the zero before it: write `{decimal}`")
    return None


def canonical(text: str) -> str | None:
    """Return the number as both readers take it: `1e-9` as `1.0e-9`."""
    if text.lower() in ("nan", "inf", "+inf", "-inf"):
        return f"{text[:-3]}.{text[-3:].lower()}"
    found = EXPONENT.fullmatch(text)
    if found is None:
        return None
    sign, whole, part, direction, power = found.groups()
    return f"{sign}{whole or '0'}.{part or '0'}e{direction or '+'}{power}"
