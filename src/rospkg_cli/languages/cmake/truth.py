"""True, false, or unknown: what a condition of CMake is worth, and which texts are constants."""

from __future__ import annotations

from ...lazy_regex import regex

Truth = bool | None
"""None: unknown."""

TRUE = frozenset({"ON", "YES", "TRUE", "Y"})
FALSE = frozenset({"", "OFF", "NO", "FALSE", "N", "IGNORE", "NOTFOUND"})
NUMBER = regex(r"[+-]?\d+(\.\d+)?")


def and_(a: Truth, b: Truth) -> Truth:
    return False if a is False or b is False else True if a and b else None


def or_(a: Truth, b: Truth) -> Truth:
    return True if a or b else False if a is False and b is False else None


def not_(a: Truth) -> Truth:
    return None if a is None else not a


def as_constant(text: str) -> Truth:
    """Return whether a text is a constant that is true or false; None where it is the name of a variable."""
    upper = text.upper()
    if upper in TRUE or (NUMBER.fullmatch(text) and float(text) != 0):
        return True
    if upper in FALSE or upper.endswith("-NOTFOUND") or NUMBER.fullmatch(text):
        return False
    return None
