"""Names that are to be filled in or replaced: `<your_name>`, or a comment at them that says so."""

from __future__ import annotations

from ...lazy_regex import regex
from .comment_lines import COMMENT, comment_in, without_opening

BLANK = regex(
    r"(?i)_*(?:to[ _]?do|tbd|fill[ _]?(?:me(?:[ _]?in)?|in|out|this)(?:[ _]here)?|fix[ _]?me|your_\w+|(?-i:X{3,})"
    r"|(?:replace|change)[ _]?(?:me|this)|insert_\w+_here)_*|_{3,}|\?{2,}"
)
REPLACED = regex(
    r"(?i)\W*(?:(?:to[ -]?do|fix-?me|please|you (?:must|should|can|need to))\W+)?"
    r"(?:change|edit|adapt|adjust|modify|replace|customi[sz]e|update|insert)\b[^\n]{0,60}"
    r"\b(?:your|this|these|here|me|own)\b"
)
THEIRS = regex(
    r"(?i)\W*(?:(?:to[ -]?do|fix-?me|please|you (?:must|should|can|may|need to|have to))\W+)?"
    r"(?:change|edit|adapt|adjust|modify|replace|customi[sz]e|update|insert|put|set|use|enter|specify|provide|point|give"
    r"|choose|select|write|add)\b[^\n]{0,60}\byour\b"
)
"""How a comment of several lines asks for a name of one's own: it says `your`."""


def is_blank(name: str) -> bool:
    """Return whether a name stands for one that is to be filled in: `___TODO___`, `<your_name>`, `FILL_ME_IN`."""
    return BLANK.fullmatch(name.strip("<>{}[] ")) is not None


def is_to_be_replaced(text: str, place: int) -> bool:
    """Return whether a comment on the line of a place, or directly above, asks for another name.

    Example: `# replace with your robot`. One above the statement that the line is a part of counts if it says `your`.
    """
    above = text[: text.rfind("\n", 0, place) + 1].split("\n")[:-1]
    if REPLACED.match(comment_in(text[text.rfind("\n", 0, place) + 1 :].partition("\n")[0])) is not None:
        return True
    above = without_opening(above)
    while above and COMMENT.match(above[-1].strip()):
        if THEIRS.match(comment_in(above.pop())):
            return True
    return False
