"""Defaults of parameters in code that the parameter files of the package replace."""

from __future__ import annotations

from collections.abc import Iterable

from ...languages.yaml.nodes import ScalarNode
from ...lazy_regex import regex
from ...package.params.parameter_file import ParameterFile

DECLARES = regex(
    r"""\bdeclare_parameter\s*(?:<[\w:]+>)?\s*\(\s*(["'])([\w.]+)\1\s*,\s*(?:std::string\s*[({]\s*)?["']\Z"""
)
LONGEST = 300
"""Characters before a default that are read."""


def is_replaced(before: str, value: str, files: Iterable[ParameterFile]) -> bool:
    """Return whether a value behind a text is a parameter's default, which all files with the parameter replace."""
    found = DECLARES.search(before[-LONGEST:])
    if found is None:
        return False
    blocks = (block for file in files for block in file.blocks)
    given = [each.value for block in blocks for each in block.parameters if each.name == found[2]]
    return bool(given) and all(isinstance(each, ScalarNode) and each.text != value for each in given)
