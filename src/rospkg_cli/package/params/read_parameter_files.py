"""Which files of a package hold parameters."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...files import ReaderInput
from ...languages.yaml.nodes import MappingNode, ScalarNode, documents
from ...lazy_regex import regex
from ...source import Source
from ...unreadable import Unreadable, UnreadableError
from ..file_role import role_of
from .node_entries import KEY
from .opened_by_code import is_for_code
from .parameter_file import ParameterFile
from .passed_files import handed_files

MENTIONS = regex(r"""^[ \t{]*["']?_*ros_+parameters?_*["']?[ \t]*(?::|$)""", re.MULTILINE | re.IGNORECASE)
WILD = regex(r"""^["']?/?\*\*?(?:/[\w*/]+)?["']?[ \t]*:""", re.MULTILINE)
"""A name for many nodes, at the top: nothing but parameters begins like this."""
OTHERS = (frozenset({"serial_number", "platform"}),)
"""What the keys at the top of other files are that hold parameters further in: of Clearpath's robot.yaml."""
TEMPLATE = regex(r"\{\{|\{%|<%")


def read_parameter_files(reading: ReaderInput) -> Iterator[ParameterFile | Unreadable]:
    """Read the YAML files that have a block of ROS parameters (perhaps misspelt) or are passed to nodes.

    Those that only code opens are none, nor are those of another kind that hold parameters further in.
    """
    handed = handed_files(reading)
    for path in reading.files.paths:
        if path.endswith((".yaml", ".yml")) and role_of(path) not in ("test", "aside"):
            source = text_of(reading, path)
            is_found = source is not None and is_parameter_file(source, path in handed)
            if source and is_found and (path in handed or not is_for_code(path, reading)):
                try:
                    file = ParameterFile(source, tuple(documents(source)))
                    if path in handed or has_parameters(file):
                        yield file
                except UnreadableError as error:
                    yield error.unreadable


def has_parameters(file: ParameterFile) -> bool:
    """Return whether a file of a block, perhaps misspelt, is one of parameters: not where only the items of a list have
    such a key, or where the keys at the top are those of another kind of file.
    """
    pairs = (pair for root in file.roots if isinstance(root, MappingNode) for pair in root.entries)
    keys = {key.text for key, _ in pairs if isinstance(key, ScalarNode)}
    if any(keys >= each for each in OTHERS):
        return False
    is_spelt = KEY in file.source.text or WILD.search(file.source.text) is not None
    return is_spelt or any(entry.kind == "block" for entry in file.entries)


def text_of(reading: ReaderInput, path: str) -> Source | None:
    """Return a file's text; None where it can't be decoded, and so is no parameter file."""
    try:
        return reading.files.source(path)
    except UnreadableError:
        return None


def is_parameter_file(source: Source, handed: bool = False) -> bool:
    """Return whether a text is one by its content; `handed` says that a launch file passes it to a node."""
    text = source.text
    return bool(handed or MENTIONS.search(text) or WILD.search(text)) and not TEMPLATE.search(text)
