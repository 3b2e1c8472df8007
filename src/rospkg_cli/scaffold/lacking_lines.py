"""What a file that was left alone does not have of what would be written there."""

from __future__ import annotations

from ..tree import TreeEntry


def lacking_lines(there: TreeEntry, wanted: TreeEntry) -> list[str] | None:
    """Return the lines that a file lacks, in their order, each once; None where it is no text.

    Indentation, blank lines and lines without a letter or digit (brackets, say) don't count.
    """
    try:
        has = {line.strip() for line in there.text.text.splitlines()}
        lines = [line.strip() for line in wanted.text.text.splitlines()]
    except (UnicodeError, OSError):
        return None
    return [line for line in dict.fromkeys(lines) if line not in has and any(map(str.isalnum, line))]
