"""Which files of a package hold parameters."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...source import Source
from ..files import Reading
from ..unreadable import Unreadable, UnreadableError
from ..uses.roles import role_of
from .file import ParameterFile
from .judge import judge
from .tree import documents

MENTIONS = re.compile(r"""^[ \t{]*["']?_*ros_+parameters?_*["']?[ \t]*:""", re.MULTILINE | re.IGNORECASE)
TEMPLATE = re.compile(r"\{\{|\{%|<%")


def read_parameter_files(reading: Reading) -> Iterator[ParameterFile | Unreadable]:
    """Read the YAML files that have a block of ROS parameters, rightly written or nearly so."""
    for path in reading.files.paths:
        if path.endswith((".yaml", ".yml")) and role_of(path) not in ("test", "aside"):
            source = text_of(reading, path)
            if source and is_parameter_file(source):
                try:
                    yield judge(source, documents(source))
                except UnreadableError as error:
                    yield error.unreadable


def text_of(reading: Reading, path: str) -> Source | None:
    """Return a file's text; None where it has none: nothing says then that it holds parameters."""
    try:
        return reading.files.source(path)
    except UnreadableError:
        return None


def is_parameter_file(source: Source) -> bool:
    return MENTIONS.search(source.text) is not None and not TEMPLATE.search(source.text)
