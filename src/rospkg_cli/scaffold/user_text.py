"""Text that a user gave, and how it gets into each kind of file.

A template can't print such a text as it stands: it must name the file's language (`{{ description | xml }}`).
"""

from __future__ import annotations

import json
import re
import unicodedata
from xml.sax.saxutils import escape

from ..light_dataclasses import dataclass
from . import ScaffoldError

WIDTH = 99
"""The longest line that ament's linters allow."""


class UnescapedError(Exception):
    """A template that prints a user's text without naming the file's language."""


@dataclass(frozen=True)
class UserText:
    """A user's text: one line of printable characters, single blanks between words."""

    text: str

    def __str__(self) -> str:
        raise UnescapedError(f"a template prints {self.text!r} as it stands; it needs a filter such as `| xml`")


def user_text(what: str, text: str) -> UserText:
    """Return a user's text on one line; raises ScaffoldError where a file could not hold it."""
    line = " ".join(text.split())
    for char in line:
        if unicodedata.category(char) in ("Cc", "Cs") or char in "\ufffe\uffff":
            shown = "bytes that are not UTF-8" if unicodedata.category(char) == "Cs" else f"U+{ord(char):04X}"
            raise ScaffoldError(f"{what} holds {shown}, which no XML file can; leave it out")
    return UserText(line)


def plain(value: UserText | str) -> str:
    """Return a text for a file without any syntax."""
    return value.text if isinstance(value, UserText) else value


def xml(value: UserText | str) -> str:
    """Return a text for XML, in an element or an attribute."""
    return escape(plain(value), {'"': "&quot;"})


def python(value: UserText | str | int | float) -> str:
    """Return a value as a Python literal, a text in single quotes where that needs no backslash."""
    return repr(value.text if isinstance(value, UserText) else value)


def cpp(value: UserText | str | int | float) -> str:
    """Return a value as a C++ literal."""
    return json.dumps(value.text if isinstance(value, UserText) else value)


def yaml(value: UserText | str | int | float) -> str:
    """Return a value as YAML; a text is quoted, so that it stays one."""
    return json.dumps(value.text if isinstance(value, UserText) else value, ensure_ascii=False)


def python_argument(value: UserText | str, name: str, indent: int = 4) -> str:
    """Return `name='text',`; a text too long for the line goes into parentheses, piece by piece."""
    line = f"{' ' * indent}{name}={python(value)},"
    if len(line) <= WIDTH:
        return line.lstrip()
    pieces = "\n".join(" " * (indent + 4) + repr(piece) for piece in pieces_of(plain(value), WIDTH - indent - 4))
    return f"{name}=(\n{pieces}\n{' ' * indent}),"


def pieces_of(text: str, width: int) -> list[str]:
    """Cut a text into pieces whose literals fit a width, after blanks where there are some."""
    pieces = []
    while len(repr(text)) > width:
        end = width - 2
        while len(repr(text[:end])) > width:
            end -= 1
        blank = text.rfind(" ", 0, end)
        end = blank + 1 if blank > 0 else end
        pieces.append(text[:end])
        text = text[end:]
    return [*pieces, text]


MARKUP = re.compile(
    r"[\\`*\[\]<]"
    r"|(?<![^\W_])_|_(?![^\W_])"  # not within a word
    r"|&(?=#?\w+;)"
    r"|^[#>+=~|-]|(?<=^\d)[.)]|(?<=^\d\d)[.)]"  # a heading, a quotation, a list
)


def markdown(value: UserText | str) -> str:
    """Return a text as a paragraph of Markdown in which nothing is markup."""
    return MARKUP.sub(r"\\\g<0>", plain(value))


def comment(value: UserText | str, mark: str = "#") -> str:
    """Return a text as lines of a comment, without the characters that are not shown (those that turn the direction of
    writing, say)."""
    text = plain(value)
    lines = ["".join(c for c in line if c.isprintable()) for line in text.rstrip("\n").split("\n")]
    return "\n".join(f"{mark} {line}".rstrip() for line in lines) + ("\n" if text.endswith("\n") else "")
