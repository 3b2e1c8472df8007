"""Comparisons in conditions of CMake: numbers, strings, versions, patterns and lists."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from ...lazy_regex import regex
from .regex import search
from .truth import Truth
from .values import UNKNOWN, Value

NUMBER_FIRST = regex(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)")
"""What EQUAL and LESS read of a text: sscanf stops where the number does.

Linear: it is only tried at the start of a word.
"""
VERSION = regex(r"\d{1,9}(\.\d{1,9})*")

NUMBERS: Mapping[str, Callable[[float, float], bool]] = {
    "EQUAL": lambda a, b: a == b,
    "LESS": lambda a, b: a < b,
    "GREATER": lambda a, b: a > b,
    "LESS_EQUAL": lambda a, b: a <= b,
    "GREATER_EQUAL": lambda a, b: a >= b,
}
STRINGS: Mapping[str, Callable[[str, str], bool]] = {
    "STREQUAL": lambda a, b: a == b,
    "STRLESS": lambda a, b: a < b,
    "STRGREATER": lambda a, b: a > b,
    "STRLESS_EQUAL": lambda a, b: a <= b,
    "STRGREATER_EQUAL": lambda a, b: a >= b,
    "PATH_EQUAL": lambda a, b: a == b,
}
BINARY = frozenset({*NUMBERS, *STRINGS, *(f"VERSION_{name}" for name in NUMBERS), "MATCHES", "IN_LIST",
                    "IS_NEWER_THAN"})  # fmt: skip


def compare(operator: str, a: str, b: str) -> Truth:
    """Compare two known texts with any operator of BINARY but IN_LIST; None where CMake refuses them."""
    if operator in STRINGS:
        return STRINGS[operator](a, b)
    if operator == "MATCHES":
        return search(b, a)
    if operator in NUMBERS:
        numbers = [float(match.group(1)) for text in (a, b) if (match := NUMBER_FIRST.match(text))]
        return NUMBERS[operator](*numbers) if len(numbers) == 2 else False if a.strip() else None
    return compare_versions(operator.removeprefix("VERSION_"), a, b)


def list_contains(value: Value, text: str) -> Truth:
    """Return whether a list has an element; None where an unknown or uncertain one may be it."""
    sure = [word.text for word in value if not word.maybe]
    if text in sure:
        return True
    return None if any(word.maybe or UNKNOWN in word.text for word in value) else False


def compare_versions(operator: str, a: str, b: str) -> Truth:
    """Compare two versions, such as `3.5` and `3.10.2`; None where one of them is none."""
    if operator not in NUMBERS or not (VERSION.fullmatch(a) and VERSION.fullmatch(b)):
        return None
    pair = [[int(part) for part in text.split(".")] for text in (a, b)]
    width = max(map(len, pair))
    left, right = ([*numbers, *[0] * (width - len(numbers))] for numbers in pair)
    return NUMBERS[operator](float((left > right) - (left < right)), 0.0)
