"""Which files of a package hold parameters."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...files import ReaderInput
from ...languages.yaml.nodes import documents
from ...lazy_regex import regex
from ...source import Source
from ...unreadable import Unreadable, UnreadableError
from ..file_role import role_of
from .opened_by_code import is_for_code
from .parameter_file import ParameterFile
from .passed_files import handed_files

MENTIONS = regex(r"""^[ \t{]*["']?_*ros_+parameters?_*["']?[ \t]*(?::|$)""", re.MULTILINE | re.IGNORECASE)
WILD = regex(r"""^["']?/?\*\*?(?:/[\w*/]+)?["']?[ \t]*:""", re.MULTILINE)
"""A name for many nodes, at the top: nothing but parameters begins like this."""
TEMPLATE = regex(r"\{\{|\{%|<%")


def read_parameter_files(reading: ReaderInput) -> Iterator[ParameterFile | Unreadable]:
    """Read the YAML files that have a block of ROS parameters (perhaps misspelt) or are passed to nodes.

    Those that only code opens are none.
    """
    handed = handed_files(reading)
    for path in reading.files.paths:
        if path.endswith((".yaml", ".yml")) and role_of(path) not in ("test", "aside"):
            source = text_of(reading, path)
            is_found = source is not None and is_parameter_file(source, path in handed)
            if source and is_found and (path in handed or not is_for_code(path, reading)):
                try:
                    yield ParameterFile(source, tuple(documents(source)))
                except UnreadableError as error:
                    yield error.unreadable


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
