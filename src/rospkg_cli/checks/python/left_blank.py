"""Blanks in place of names, and comments that say what is still to be written.

Exercises and skeletons have both: what they lack is the task of their readers.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...lazy_regex import regex
from .blank_words import MAKING, OPEN, TO_DO, says_name

COMMENT = regex(r"(?:^|\s)(?:#|//|<!--)(.*)")
HOLE = regex(r"\?{3}|_{3,}\s*[,)]")
"""What stands for a part of code that is to be filled in: `create_publisher(???, 10)`."""
DOTS = regex(r"\W*(?:\.{3,}|…|_{3,})\W*")
BLANK = regex(
    r"(?i)_*(?:to[ _]?do|tbd|fill[ _]?(?:me(?:[ _]?in)?|in|out|this)(?:[ _]here)?|fix[ _]?me|your_\w+|(?-i:X{3,})"
    r"|(?:replace|change)[ _]?(?:me|this)|insert_\w+_here)_*|_{3,}|\?{2,}"
)
REPLACED = regex(
    r"(?i)\W*(?:(?:to[ -]?do|fix-?me|please|you (?:must|should|can|need to))\W+)?"
    r"(?:change|edit|adapt|adjust|modify|replace|customi[sz]e|update|insert)\b[^\n]{0,60}"
    r"\b(?:your|this|these|here|me|own)\b"
)
MADE = r"(?:implemented|written|ported|finished|done|available|made|added|there)"
UNMADE = regex(
    rf"(?i)\b(?:not|isn['’]?t|aren['’]?t) {MADE} yet\b|\bnot yet {MADE}\b|\bnot implemented\b|\bcoming soon\b"
    r"|\bstill (?:missing|to come|to be (?:implemented|written|ported|added|made))\b"
)
"""How a comment says that what it is next to is not written yet."""
THEIRS = regex(
    r"(?i)\W*(?:(?:to[ -]?do|fix-?me|please|you (?:must|should|can|may|need to|have to))\W+)?"
    r"(?:change|edit|adapt|adjust|modify|replace|customi[sz]e|update|insert|put|set|use|enter|specify|provide|point|give"
    r"|choose|select|write|add)\b[^\n]{0,60}\byour\b"
)
"""How a comment of several lines asks for a name of one's own: it says `your`."""
OPENING = regex(r"\s*<[\w:]+(?:\s[^<>]*)?(?<!/)>\s*|.*[(\[{]\s*|\s*[\"'][\w/]+[\"'],\s*")
"""A line that only opens what the next one is a part of."""
STEPS = 3
"""How many such lines may stand between a comment and what it is about."""
BETWEEN = regex(r"[^\W\d_]+")
SHORT = 3
"""How many letters of two words must be the same: `pub` means the publisher."""


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


def without_opening(lines: list[str]) -> list[str]:
    """Return lines without the last few that only open what the next line is a part of."""
    end = len(lines)
    while end and len(lines) - end < STEPS and opens(lines[end - 1]):
        end -= 1
    return lines[:end]


def opens(line: str) -> bool:
    return OPENING.fullmatch(line) is not None and COMMENT.match(line.strip()) is None


def announces(text: str, place: int, name: str, *, behind: bool = False) -> bool:
    """Return whether a comment in the block of a place, before it, says that something of a name is to be written.

    It names it (`# TODO: create the client` of `self.service_client`), stands directly above, or asks for code
    in general (`# YOUR CODE HERE`). With `behind`, the comments behind the place count as well.
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
    """Return whether a comment that is in no block asks for code: what a file as a whole lacks belongs there."""
    return any(OPEN.search(comment_in(line)) for line in text.split("\n") if line.startswith(("#", "//")))


def has_task(text: str) -> bool:
    """Return whether a comment asks for something to be written, or has a hole in commented code."""
    return any(is_asked(said) or HOLE.search(said) for said in comment_blocks(text))


def is_asked(said: str) -> bool:
    return bool(OPEN.search(said) or (TO_DO.search(said) and MAKING.search(said)))


def comment_blocks(text: str) -> Iterator[str]:
    """Yield what comments say, those of lines that follow each other as one."""
    block: list[str] = []
    for line in (*text.split("\n"), ""):
        if said := comment_in(line):
            block.append(said)
        elif block:
            yield "\n".join(block)
            block = []


def comments_behind(lines: list[str], at: int) -> Iterator[str]:
    for line in lines[at:]:
        if is_outer(line, lines[at]):
            return
        yield comment_in(line)


def is_outer(line: str, inner: str) -> bool:
    """Return whether a line is outside of the block of another one."""
    return bool(line.strip()) and indent(line) < indent(inner)


def indent(line: str) -> int:
    return len(line) - len(line.lstrip())


def comment_in(line: str) -> str:
    found = COMMENT.search(line)
    return found[1].strip(" \t#/*-=<>!") or " " if found is not None else ""


def is_task(said: str, name: str, *, is_near: bool) -> bool:
    """Return whether a comment says that what a name means is to be written."""
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
