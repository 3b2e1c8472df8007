"""The type that rcl gives a value of a parameter file, and launch_ros the text of a value in a launch file."""

from __future__ import annotations

from ...languages.yaml.nodes import ScalarNode, YamlNode
from ...languages.yaml.nodes import SequenceNode as YamlSequence
from ...lazy_regex import regex
from ...package.params.parameter_file import has_placeholder
from ...package.params.scalar_types import DOUBLE, FALSE, TRUE, type_of, yaml_type

PLACEHOLDER = regex(r"<.*>|[A-Z][A-Z0-9]*(?:_[A-Z0-9]+)+|__\w+__|.*[{}@%].*")
"""A text that a launch file replaces before the node gets it."""


def given_type(value: YamlNode) -> str:
    """Return the type that rcl gives a value; "" where it has none, or it is filled in later."""
    if isinstance(value, ScalarNode):
        is_open = value.is_plain and (not value.text or PLACEHOLDER.fullmatch(value.text))
        return "" if is_open or has_placeholder(value.text) else type_of(value)
    if isinstance(value, YamlSequence) and value.items:
        types = {given_type(item) for item in value.items}
        only = types.pop() if len(types) == 1 else ""
        return f"{only}[]" if only and "[" not in only else ""
    return ""


def is_number_of_rcl(text: str) -> bool:
    """Return whether a text is a string for PyYAML, which writes it without quotes, and a number for rcl: `1e-3`."""
    return yaml_type(text) == "string" and bool(DOUBLE.fullmatch(text))


def type_of_text(text: str) -> str:
    """Return the type of a text that PyYAML reads; "" for what is no plain scalar."""
    if not text.strip() or text[0] in "[{'\"|>&*!":
        return ""
    return "bool" if text in TRUE | FALSE and len(text) > 1 else yaml_type(text)
