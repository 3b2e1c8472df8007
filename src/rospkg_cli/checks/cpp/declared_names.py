"""Where a text of C++ declares a name, and up to where that is known."""

from __future__ import annotations

from collections.abc import Set

from ...lazy_regex import regex

DECLARED = regex(r"\s*[;=({,)\[:]")
SCOPE = regex(r"[(){};]")
NO_TYPES = frozenset({"return", "else", "throw", "case", "delete", "co_return", "co_yield", "co_await"})
"""Words that stand before an expression, and are no type."""


def is_no_other(text: str, name: str, known: Set[int]) -> bool:
    """Return whether a text declares a name at no other places than these, but for structured bindings."""
    at = text.find(name)
    while at >= 0:
        end = at + len(name)
        if at not in known and has_type_before(text, at) and DECLARED.match(text, end):
            return False
        at = text.find(name, end)
    return True


def has_type_before(text: str, at: int) -> bool:
    """Return whether a name begins at an offset, and what stands before it is a type, not the end of an expression."""
    if is_of_word(text[at - 1 : at]) or text[at - 1 : at] == ".":
        return False
    end = at
    while text[end - 1 : end].isspace():
        end -= 1
    last = text[end - 1 : end]
    if not is_of_word(last):
        return last in ("&", "*") or (end < at and last in (">", "]"))
    start = end
    while is_of_word(text[start - 1 : start]):
        start -= 1
    return text[start:end] not in NO_TYPES


def is_of_word(char: str) -> bool:
    return char.isalnum() or char == "_"


def end_of_scope(text: str, at: int) -> int:
    """Return where the block ends that a declaration stands in; of a parameter, that of the function's body."""
    depth, inside = 0, 0
    for match in SCOPE.finditer(text, at):
        sign = match[0]
        if sign == "(":
            inside += 1
        elif sign == ")":
            inside -= 1
        elif sign == ";" and inside < 0 and depth == 0:
            return at  # a declaration of a function, which has no body
        elif sign == "{":
            depth += 1
        elif sign == "}":
            depth -= 1
            if depth < 0 or (depth == 0 and inside < 0):
                return match.end()
    return at
