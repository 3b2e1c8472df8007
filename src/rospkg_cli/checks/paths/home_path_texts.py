"""How paths in a home folder are written in launch files, YAML, CMake and code."""

from __future__ import annotations

import io
import re
from itertools import accumulate
from tokenize import COMMENT, DEDENT, INDENT, NEWLINE, NL, STRING, TokenError, generate_tokens

from ...lazy_regex import regex

MARKUP = (".launch", ".launch.xml", "_launch.xml")
YAML = (".yaml", ".yml", ".rviz")
CPP = (".cpp", ".cc", ".cxx", ".hpp", ".h")
NO = r"${}<>%\\\s\"'`,;:*()"
"""What no path of these has: in code a backslash makes a line of a text for people of it."""
PATH = rf"(?:/home/(?P<user>[^/{NO}]+)/|/Users/(?P<mac>[^/{NO}]+)/)[^{NO}]+"
QUOTED = regex(rf"(?<=[\"'=])(?:file://)?(?P<path>{PATH})(?=[\"'])")
PLAIN = regex(rf"(?m)(?<=[:-])[ \t]+(?:file://)?(?P<path>{PATH})(?=[ \t]*(?:#.*)?$)")
"""The value of a key, or an element of a list, without quotes."""

IN_CMAKE = regex(rf"(?<![\w./-])(?<!DESTINATION )(?P<path>{PATH})(?![\w*$])")
COMMENTS = {CPP: regex(r"(?s)/\*.*?\*/|//[^\n]*"), MARKUP: regex(r"(?s)<!--.*?-->")}
IS_SOUGHT = regex(
    r"\bsys\.path\b(?:[^\n]*|[^)\]]*)\Z|\b(?:target_)?(?:link|include)_directories\s*\([^)]*\Z"
    r"|\b(?:set|list)\s*\(\s*(?:APPEND\s+|PREPEND\s+)?(?:CMAKE|AMENT)_PREFIX_PATH\b[^)]*\Z"
)
"""Whether what follows is one of the places for modules, headers, libraries or packages."""
MACRO = regex(r"[ \t]*#[ \t]*define[ \t]+(\w+)")
OPENING = (NEWLINE, INDENT, DEDENT)
"""What a statement follows."""
AFTER_HASH = regex(r"(?m)(?:^|(?<=\s))#[^\n]*")
BUT_LINES = regex(r"[^\n]")
ASKS = regex(r"\b(?:l?exists|isfile|is_file|isdir|is_dir|access)\(|\bif\s*\([^()]*\bEXISTS\b")


def is_guarded_macro(text: str, place: int) -> bool:
    """Return whether a place is in a macro of C++ that the build may define instead: `#ifndef DATA`, `#define DATA`."""
    line = text[:place].rpartition("\n")[2]
    macro = MACRO.match(line)
    return macro is not None and re.search(rf"(?m)^[ \t]*#[ \t]*ifndef[ \t]+{macro[1]}\b", text) is not None


def patterns(path: str) -> tuple[re.Pattern[str], ...]:
    if path.endswith("CMakeLists.txt"):
        return (IN_CMAKE,)
    return (QUOTED, PLAIN) if path.endswith(YAML) else (QUOTED,)


def is_in_handler(text: str, place: int) -> bool:
    """Return whether a place in Python is below `except`, where something else was tried before."""
    around: int | None = None
    for line in reversed(text[:place].split("\n")):
        depth = len(line) - len(line.lstrip())
        if line.strip() and (around is None or depth < around):
            if line.lstrip().startswith("except") and around is not None:
                return True
            if depth == 0:
                return False
            around = depth
    return False


def without_comments(path: str, text: str) -> str:
    """Return a text with blanks in place of comments, so that what is left keeps its place."""
    for suffixes, pattern in COMMENTS.items():
        if path.endswith(suffixes):
            return pattern.sub(lambda match: " " * len(match[0]), text)
    if path.endswith(".py"):
        return without_remarks(text)
    return AFTER_HASH.sub(lambda match: " " * len(match[0]), text)


def without_remarks(text: str) -> str:
    """Return Python code without its comments, and without strings that stand alone: code that is switched off."""
    lines = text.splitlines(keepends=True)
    starts = [0, *accumulate(map(len, lines))]
    try:
        tokens = list(generate_tokens(io.StringIO(text).readline))
    except (TokenError, SyntaxError):
        return AFTER_HASH.sub(lambda match: " " * len(match[0]), text)
    before = NEWLINE
    for token in tokens:
        is_alone = token.type == STRING and before in OPENING
        if token.type == COMMENT or is_alone:
            start, end = (starts[row - 1] + column for row, column in (token.start, token.end))
            text = text[:start] + BUT_LINES.sub(" ", text[start:end]) + text[end:]
        before = before if token.type in (COMMENT, NL) else token.type
    return text
