"""Comments that say what is still to be written.

Exercises and skeletons have them: what they lack is the task of their readers.
"""

from __future__ import annotations

import re

from ...lazy_regex import regex
from .blank_words import MAKING, OPEN, TO_DO, says_name
from .comment_lines import COMMENT, comment_blocks, comment_in, comments_behind, is_outer, without_opening

HOLE = regex(r"\?{3}|_{3,}\s*[,)]")
"""A blank for a part of code that is to be filled in: `create_publisher(???, 10)`."""
DOTS = regex(r"\W*(?:\.{3,}|…|_{3,})\W*")
MADE = r"(?:implemented|written|ported|finished|done|available|made|added|there)"
UNMADE = regex(
    rf"(?i)\b(?:not|isn['’]?t|aren['’]?t) {MADE} yet\b|\bnot yet {MADE}\b|\bnot implemented\b|\bcoming soon\b"
    r"|\bstill (?:missing|to come|to be (?:implemented|written|ported|added|made))\b"
)
"""How a comment says that what it is next to is not written yet."""
BETWEEN = regex(r"[^\W\d_]+")
SHORT = 3
"""How many letters of two words must be the same: `pub` means the publisher."""


def announces(text: str, place: int, name: str, *, behind: bool = False) -> bool:
    """Return whether a comment before a place, in its block, says that something with a name is to be written.

    The comment has a word of the name (`# TODO: create the client` for `self.service_client`), is directly above, or
    asks for code in general (`# YOUR CODE HERE`). With `behind`, comments after the place count as well.
    """
    lines = text.split("\n")
    at = text.count("\n", 0, place)
    is_near = True
    for number in range(at - 1, -1, -1):
        if is_outer(lines[number], lines[at]):
            break
        is_near = is_near and (not lines[number].strip() or COMMENT.match(lines[number].strip()) is not None)
        if is_task(comment_in(lines[number]), name, is_near=is_near):
            return True
    return behind and any(is_task(each, name, is_near=False) for each in comments_behind(lines, at))


def is_asked_for(text: str, name: str) -> bool:
    """Return whether a comment anywhere in a text says that something of a name is to be written, and names it."""
    return any(is_asked(said) and says_name(said, name) for said in comment_blocks(text))


def is_asked_at(text: str, place: int, name: str) -> bool:
    """Return whether a comment in the line of a place, or in those directly above, asks for something of a name."""
    lines = text.split("\n")
    at = text.count("\n", 0, place)
    said = [comment_in(lines[at])]
    for line in reversed(without_opening(lines[:at])):
        if COMMENT.match(line.strip()) is None:
            break
        said.append(comment_in(line))
    whole = "\n".join(reversed(said))
    return UNMADE.search(whole) is not None or (is_asked(whole) and shares_word(MAKING.sub("", whole), name))


def asks_to(text: str, task: str) -> bool:
    """Return whether a comment says that something is still to be done, by an expression for it."""
    return any(TO_DO.search(said) and re.search(rf"(?i)\b{task}", said) for said in comment_blocks(text))


def asks_at_the_top(text: str) -> bool:
    """Return whether a comment at the start of a line asks for code, which the file as a whole lacks."""
    return any(OPEN.search(comment_in(line)) for line in text.split("\n") if line.startswith(("#", "//")))


def has_task(text: str) -> bool:
    """Return whether a comment asks for something to be written, or has a hole in commented code."""
    return any(is_asked(said) or HOLE.search(said) for said in comment_blocks(text))


def is_asked(said: str) -> bool:
    return bool(OPEN.search(said) or (TO_DO.search(said) and MAKING.search(said)))


def is_task(said: str, name: str, *, is_near: bool) -> bool:
    """Return whether a comment says that what a name refers to is to be written."""
    if not said:
        return False
    if OPEN.search(said):
        return True
    if not TO_DO.search(said):
        return is_near and DOTS.fullmatch(said) is not None
    is_bare = TO_DO.fullmatch(said.strip(" :.")) is not None
    if not (MAKING.search(said) or is_bare):
        return False
    return is_near or shares_word(MAKING.sub("", said), name)


def shares_word(said: str, name: str) -> bool:
    """Return whether a text has a word of a name, or the beginning of one."""
    words, own = ([each.lower() for each in BETWEEN.findall(text)] for text in (said, name))
    return any(is_same(one, other) for one in words for other in own)


def is_same(one: str, other: str) -> bool:
    short, long = sorted((one, other), key=len)
    return len(short) >= SHORT and long.startswith(short)
