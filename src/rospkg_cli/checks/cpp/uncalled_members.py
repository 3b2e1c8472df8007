"""Functions of C++ nodes that no code of the package names but where it declares and defines them."""

from __future__ import annotations

import re
from collections.abc import Sequence

from ...languages.cpp.enclosing import NAME, OVERRIDES, heads
from ...languages.cpp.file import CppFile
from ...languages.cpp.lexer import TOKEN
from ...lazy_regex import regex
from ...source import Span

PLAIN = regex(r":\s*(?:public\s+)?(?:rclcpp::)?Node\s*\{")
"""A class whose one base is the node of rclcpp, which calls no function of it."""
TYPES = regex(r"[\w:<>,&*~ \t]*[\w>&*][ \t&*]*[ \t](?:\w+::)*|[ \t]*(?:\w+::)+")
"""What stands before a name in the line where it is declared or defined."""
NO_TYPE = frozenset({"return", "else", "co_return", "co_await", "throw", "delete", "new", "case"})


def is_in_uncalled(file: CppFile, place: Span, files: Sequence[CppFile]) -> bool:
    """Return whether a place is in a function that no code calls, where each class with a base is a plain node.

    A constructor is called by the name of its class.
    """
    codes = [blanked(each) for each in files]
    head = next(heads(blanked(file), place.start), "")
    found = NAME.search(head)
    if found is None or OVERRIDES.search(head) or not any(map(PLAIN.search, codes)):
        return False
    word = re.compile(rf"(?<![\w~]){found[1]}(?!\w)")
    is_class = any(re.search(rf"\b(?:class|struct)\s+{found[1]}\b", code) for code in codes)
    return not is_class and found[1] != "main" and not any(mentions(word, code) for code in codes)


def mentions(word: re.Pattern[str], code: str) -> bool:
    """Return whether code names a function otherwise than where it declares or defines it."""
    for found in word.finditer(code):
        before = code[code.rfind("\n", 0, found.start()) + 1 : found.start()]
        is_called = code[found.end() :].lstrip()[:1] == "("
        if not is_called or not TYPES.fullmatch(before) or not NO_TYPE.isdisjoint(before.split()):
            return True
    return False


def blanked(file: CppFile) -> str:
    """Return the text of a file with blanks in the place of comments and literals."""
    return TOKEN.sub(lambda match: match[0] if match[0].startswith("#") else " " * len(match[0]), file.source.text)
