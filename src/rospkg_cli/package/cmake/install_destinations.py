"""Destinations of install rules, relative to the prefix that everything is installed to."""

from __future__ import annotations

import posixpath
from collections.abc import Sequence
from itertools import pairwise

from ...languages.cmake.call_stack import PYTHON
from ...languages.cmake.values import PREFIX, UNKNOWN, Word
from ...lazy_regex import regex
from .install_keywords import OPTIONS

TYPES = {"BIN": "bin", "SBIN": "sbin", "LIB": "lib", "INCLUDE": "include", "SYSCONF": "etc", "DATA": "share"}
"""Where `TYPE` puts files, by GNUInstallDirs."""

SITE = regex(r"\Alib/python3(?:\.\d+)?/(?:site|dist)-packages(?=/|\Z)")
"""Where modules go, with the version of Python written out: they are found on distributions with that Python alone."""


def plain_root(text: str) -> str:
    """Return a path with one slash at its root: `/${CMAKE_INSTALL_PREFIX}` names the prefix."""
    return "/" + text.lstrip("/") if text.startswith("//") else text


def below_prefix(text: str) -> str | None:
    """Return a destination relative to the prefix; None where it is unknown."""
    text = plain_root(text)
    if text.startswith(PREFIX):
        text = text[len(PREFIX) :].lstrip("/") or "."
    if UNKNOWN in text or "\1" in text or "$<" in text:
        return None
    return SITE.sub(PYTHON, posixpath.normpath(text)) if text else "."


def destination_of(words: Sequence[Word]) -> tuple[str | None, Word | None]:
    """Return the destination that the words of `install(…)` give last, which counts, and its word."""
    given = {before.text: word for before, word in pairwise(words) if word.text not in OPTIONS}
    if word := given.get("DESTINATION"):
        return below_prefix(word.text), word
    return (TYPES.get(given["TYPE"].text) if "TYPE" in given else None), None
