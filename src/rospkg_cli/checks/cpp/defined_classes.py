"""The full names of classes, with the namespaces in which files define them."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from ...languages.cpp.code_text import code_text
from ...languages.cpp.enclosing import openings
from ...languages.cpp.file import CppFile
from ...lazy_regex import regex

NAMESPACE = regex(r"\bnamespace\s+([A-Za-z_]\w*(?:\s*::\s*\w+)*)\s*\Z")
BODY = r"\b(?:class|struct)\s+(?:[A-Z][A-Z0-9_]*\s+)?{0}\b(?:\s+final)?\s*(?::(?!:)[^;{{}}()]*)?\{{"
PLAIN = regex(r"[A-Za-z_]\w*")


def defined_as(name: str, sources: Iterable[CppFile]) -> str:
    """Return the full name of the class that is intended by one with other namespaces; "" where it is not the only one.

    It is "" as well where there is a class of that name, or one within something else than a namespace.
    """
    last = name.rpartition("::")[2]
    files = [each for each in sources if last in each.source.text] if PLAIN.fullmatch(last) else []
    found = {full for each in files for full in full_names(code_text(each.source.text), last)}
    (full,) = found if len(found) == 1 else ("",)
    return full if full != name.removeprefix("::") else ""


def full_names(code: str, name: str) -> Iterator[str]:
    """Yield the full name of each class of a name that a text defines; "" for one that is not in namespaces alone."""
    for found in re.finditer(BODY.format(name), code):
        spaces = [NAMESPACE.search(each) for each in openings(code, found.start())]
        names = ["".join(each[1].split()) for each in spaces if each is not None]
        yield "::".join([*names, name]) if len(names) == len(spaces) else ""
