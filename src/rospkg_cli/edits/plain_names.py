"""Names that can be written into a file of another language without quoting."""

from __future__ import annotations

from ..finding import Fix
from ..lazy_regex import regex

PLAIN = regex(r"[\w.~/](?:[\w.+/:-]*\w)?")
"""Nothing that CMake, XML, YAML, Python or C++ would read as more than a part of a name, a path or a type.

Linear: it has to fit a whole name, from its start.
"""


def only_plain_names(fix: Fix | None, *texts: str) -> Fix | None:
    """Return a fix where all that it writes is plain; None where a text could be read as something else."""
    return fix if all(PLAIN.fullmatch(text) for text in texts) else None
