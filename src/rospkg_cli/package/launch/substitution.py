"""Parse `$(name arguments)` as the XML and YAML frontends do: by the grammar of ros2/launch (frontend/grammar.lark).

Arguments are one blank apart; a quoted argument (`'…'`, `"…"`) may hold blanks; a backslash escapes
what follows it.
"""

from __future__ import annotations

import re

from ...languages.located_text import LocatedText
from ...lazy_regex import regex
from ...read_problem import ReadProblem
from .text import LaunchText, Literal, Substitution

NAME = regex(r"[A-Za-z][A-Za-z0-9_-]*")
OUTSIDE = regex(r"(?:[^$]|\$(?!\()|(?<=\\)\$)+")
"""Text between substitutions."""

ARGUMENT = {
    "": regex(r"""(?:[^ '\\"$()]|\\["'$()]|\$(?!\()|(?<=\\)\$|\\)+"""),
    "'": regex(r"""(?:[^ '\\$()]|\\['$()]|\$(?!\()|(?<=\\)\$|\\)+"""),
    '"': regex(r"""(?:[^ "\\$()]|\\["$()]|\$(?!\()|(?<=\\)\$|\\)+"""),
}
"""A piece of an argument, by the quotes around the whole substitution."""

QUOTED = {
    "'": regex(r"(?:[^'\\$]|\\'|\$(?!\()|(?<=\\)\$|\\)+"),
    '"': regex(r'(?:[^"\\$]|\\"|\$(?!\()|(?<=\\)\$|\\)+'),
}
ESCAPED = regex(r"\\(.)")
MAX_DEPTH = 20


class SubstitutionError(ValueError):
    """The text is not what the grammar takes; `at` is the offset where it stops being it."""

    def __init__(self, at: int, code: ReadProblem, details: tuple[str, ...]) -> None:
        super().__init__(code.name, *details)
        self.at, self.code, self.details = at, code, details


def parse_text(written: LocatedText) -> LaunchText:
    """Parse a value; raises SubstitutionError."""
    return SubstitutionParser(written).template("", 0)


class SubstitutionParser:
    def __init__(self, written: LocatedText) -> None:
        self.written, self.text, self.at = written, written.text, 0

    def fail(self, code: ReadProblem, *details: str) -> SubstitutionError:
        return SubstitutionError(self.at, code, details)

    def piece(self, pattern: re.Pattern[str]) -> Literal | None:
        match = pattern.match(self.text, self.at)
        if match is None:
            return None
        self.at = match.end()
        return Literal(ESCAPED.sub(r"\1", match.group()), self.written.part(*match.span()))

    def template(self, quote: str, depth: int) -> LaunchText:
        """Read text and substitutions up to the end, or up to the closing quote."""
        start = self.at
        parts: list[Literal | Substitution] = []
        while self.at < len(self.text) and not (quote and self.text[self.at] == quote):
            if self.text.startswith("$(", self.at):
                parts.append(self.substitution(quote, depth))
                continue
            found = self.piece(QUOTED[quote] if quote else OUTSIDE)
            assert found is not None
            parts.append(found)
        return LaunchText(self.written.part(start, self.at), tuple(parts))

    def substitution(self, quote: str, depth: int) -> Substitution:
        start = self.at
        if depth > MAX_DEPTH:
            raise self.fail(ReadProblem.SUBSTITUTION_DEPTH, str(MAX_DEPTH))
        name = NAME.match(self.text, start + 2)
        self.at += 2
        if name is None:
            raise self.fail(ReadProblem.SUBSTITUTION_NAME)
        self.at = name.end()
        arguments = []
        while self.text.startswith(" ", self.at):
            self.at += 1
            arguments.append(self.argument(quote, depth + 1))
        if not self.text.startswith(")", self.at):
            self.refuse(start, name.group())
        self.at += 1
        return Substitution(name.group(), tuple(arguments), self.written.part(start, self.at))

    def refuse(self, start: int, name: str) -> None:
        if self.at >= len(self.text):
            self.at = start
            raise self.fail(ReadProblem.SUBSTITUTION_OPEN, name)
        raise self.fail(ReadProblem.SUBSTITUTION_CHARACTER, self.text[self.at], name)

    def argument(self, quote: str, depth: int) -> LaunchText:
        """Read one argument: a quoted text where the quotes are not used around it, or pieces without a blank."""
        start, first = self.at, self.text[self.at : self.at + 1]
        if not quote and first in QUOTED and first:
            self.at += 1
            inner = self.template(first, depth)
            if not self.text.startswith(first, self.at):
                self.at = start
                raise self.fail(ReadProblem.SUBSTITUTION_QUOTE, first)
            self.at += 1
            return inner
        parts: list[Literal | Substitution] = []
        while self.at < len(self.text):
            if self.text.startswith("$(", self.at):
                parts.append(self.substitution(quote, depth))
            elif (found := self.piece(ARGUMENT[quote])) is not None:
                parts.append(found)
            else:
                break
        if not parts:
            raise self.fail(ReadProblem.SUBSTITUTION_ARGUMENT)
        return LaunchText(self.written.part(start, self.at), tuple(parts))
