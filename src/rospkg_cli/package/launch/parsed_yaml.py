"""The YAML files that launch files parse themselves: their nodes get values of them, and rcl never reads them."""

from __future__ import annotations

from collections.abc import Iterator

from ...files import ReaderInput
from ...lazy_regex import regex
from .launch_file import LaunchFile
from .text import LaunchText, Literal

LOADS = regex(r"\b(?:yaml\.load|safe_load|full_load|unsafe_load)\s*\(")
WORDS = ("yaml.load", "safe_load", "full_load")
"""One of them stands in each of these."""
QUOTED = regex(r"[\"'](?:[^\"'\n]*/)?([\w.-]+\.ya?ml)[\"']")
LOOKED_UP = regex(r"(?:\[|\.get\()\s*[\"'](\w+)[\"']")


def parsed_yaml(reading: ReaderInput) -> frozenset[str]:
    """Return the names of the YAML files that Python launch files name which also call a YAML parser.

    Without those that a launch file of the package gives to a node by their path.
    """
    files = [file for file in reading.parts(LaunchFile).good if not file.is_ros1]
    texts = (file.source.text for file in files if file.frontend == "python")
    named = {name for text in texts if loads_yaml(text) for name in QUOTED.findall(text)}
    return frozenset(named - {name for file in files for name in given(file)})


def parsed_keys(reading: ReaderInput) -> frozenset[str]:
    """Return the keys that Python launch files look up in the YAML that they parse: `data["hardware"]`."""
    texts = (file.source.text for file in reading.parts(LaunchFile).good if file.frontend == "python")
    return frozenset(key for text in texts if loads_yaml(text) for key in LOOKED_UP.findall(text))


def loads_yaml(text: str) -> bool:
    return any(word in text for word in WORDS) and LOADS.search(text) is not None


def given(file: LaunchFile) -> Iterator[str]:
    """Yield the last part of each path that is given to a node as a parameter file, also by an argument's default."""
    texts = [entry.file for node in file.nodes for entry in node.parameters if entry.file is not None]
    for text in (*texts, *(each.default for each in file.arguments if each.default is not None)):
        yield last_part(text)


def last_part(text: LaunchText) -> str:
    part = text.parts[-1] if text.parts else None
    return part.text.rpartition("/")[2] if isinstance(part, Literal) else ""
