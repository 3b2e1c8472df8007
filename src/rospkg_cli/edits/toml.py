"""Remove keys from a TOML file by spans; the parser checks the result."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator, Sequence
from copy import deepcopy
from typing import Any

from ..lazy_regex import regex
from ..source import Span

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

TABLE = regex(r"""[ \t]*(?:[\w-]+\.|"[^"\n]*"\.|'[^'\n]*'\.)*""")
"""What may come before a key in its line: nothing, or the tables that lead to it.

Linear at one place: it only has to fit from the start of a line, and its parts begin differently.
"""
STRING = r"""(?:"(?:[^"\\\n]|\\.)*"|'[^'\n]*')"""


def find_entry(text: str, keys: Sequence[str]) -> tuple[Span, Span] | None:
    """Return the spans of a key whose value is a one-line string, and of what to delete so that it is gone.

    `keys` leads to it from the top: ("tool", "rospkg", "ignore", "XML104"). None where it isn't there or its form is
    another.
    """
    try:
        data = tomllib.loads(text)
    except tomllib.TOMLDecodeError:  # a lone carriage return, which is read as a line end elsewhere
        return None
    if not isinstance(value_at(data, keys), str):
        return None
    wanted = deepcopy(data)
    del value_at(wanted, keys[:-1])[keys[-1]]
    for key, whole in candidate_entries(text, keys[-1]):
        if without_empty_tables(parse_toml(text[: whole.start] + text[whole.end :])) == without_empty_tables(wanted):
            return key, whole
    return None


def value_at(data: Any, keys: Sequence[str]) -> Any:
    for key in keys:
        data = data.get(key) if isinstance(data, dict) else None
    return data


def candidate_entries(text: str, key: str) -> Iterator[tuple[Span, Span]]:
    """Yield each `key = "…"`, with its line where that holds nothing else, or with the comma before or behind it."""
    name = re.escape(key)
    for match in re.finditer(rf"(?:(?<=[\s{{,.])|^)(?:{name}|\"{name}\"|'{name}')[ \t]*=[ \t]*{STRING}", text):
        before = text[: match.start()]
        line = before.rfind("\n") + 1
        rest = re.compile(r"[ \t]*(?:#[^\n]*)?(?:\n|$)").match(text, match.end())
        span = Span(match.start(), match.start() + len(match.group().split("=")[0].rstrip()))
        if rest and TABLE.fullmatch(before, line):
            yield span, Span(line, rest.end())
        after = re.compile(r"[ \t]*,[ \t]*").match(text, match.end())
        if after:
            yield span, Span(match.start(), after.end())
        left = before.removesuffix("\n").rstrip(" \t")
        start = len(left[:-1].rstrip(" \t")) if left.endswith(",") else match.start()
        yield span, Span(start, match.end())


def without_empty_tables(data: Any) -> Any:
    """Return the data without empty tables: a dotted key takes its table along."""
    if not isinstance(data, dict):
        return data
    return {key: value for key, value in ((k, without_empty_tables(v)) for k, v in data.items()) if value != {}}


def parse_toml(text: str) -> Any:
    try:
        return tomllib.loads(text)
    except tomllib.TOMLDecodeError:
        return None
