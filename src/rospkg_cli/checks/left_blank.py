"""What a text leaves to be written: blanks in place of names, and comments that say what is to be filled in.

Exercises and skeletons are full of both: what they lack is the task of whoever takes them on.
"""

from __future__ import annotations

from collections.abc import Iterator

from ..lazy_regex import regex

COMMENT = regex(r"(?:^|\s)(?:#|//|<!--)(.*)")
TO_DO = regex(r"(?i)\bto[ -]?dos?\b|\bfix-?me\b|\bexercise\b")
MAKING = regex(
    r"(?i)\b(?:creat|add|defin|implement|writ|complet|initiali[sz]|instantiat|fill|declar|insert|import|finish)\w*"
)
OPEN = regex(
    r"(?i)\b(?:your|student'?s?) (?:own )?(?:code|solution|implementation|answer|work)\b|\bcode (?:goes )?here\b"
    r"|\bfill (?:me )?in\b|\bcomplete (?:this|the (?:code|function|method|class))\b"
)
DOTS = regex(r"\W*(?:\.{3,}|…|_{3,})\W*")
BLANK = regex(
    r"(?i)_*(?:to[ _]?do|tbd|fill[ _]?(?:me(?:[ _]?in)?|in|out|this)(?:[ _]here)?|fix[ _]?me|your_\w+|(?-i:X{3,})"
    r"|(?:replace|change)[ _]?(?:me|this)|insert_\w+_here)_*|_{3,}|\?{2,}"
)
BETWEEN = regex(r"[^\W\d_]+")
SHORT = 3
"""How many letters of two words must be the same: `pub` means the publisher."""


def is_blank(name: str) -> bool:
    """Return whether a name stands for one that is to be filled in: `___TODO___`, `<your_name>`, `FILL_ME_IN`."""
    return BLANK.fullmatch(name.strip("<>{}[] ")) is not None


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
