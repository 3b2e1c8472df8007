"""`required-version` of the config: comparisons of dotted numbers, joined by commas."""

from __future__ import annotations

import operator
import re
from collections.abc import Callable, Mapping

from ..lazy_regex import regex

Version = tuple[int, ...]
SIGNS: Mapping[str, Callable[[Version, Version], bool]] = {
    "==": operator.eq,
    "!=": operator.ne,
    ">=": operator.ge,
    "<=": operator.le,
    ">": operator.gt,
    "<": operator.lt,
}
ONE = regex(r"(==|!=|>=|<=|>|<)?\s*(\d+(?:\.\d+)*)")


def satisfies(version: str, wanted: str) -> bool:
    """Return whether a version satisfies a requirement such as `>=0.1,<0.3`; raises ValueError for any other text."""
    own = numbers(version)
    for each in wanted.split(","):
        found = ONE.fullmatch(each.strip())
        if found is None:
            raise ValueError(f"`{wanted}` is no requirement such as `>=0.1,<0.3`")
        if not SIGNS[found.group(1) or "=="](own, numbers(found.group(2))):
            return False
    return True


def numbers(version: str) -> Version:
    """Return the numbers of a version, without zeros at the end: 1.0 is 1."""
    found = [int(number) for number in re.findall(r"\d+", version)]
    while found and not found[-1]:
        found.pop()
    return tuple(found)
