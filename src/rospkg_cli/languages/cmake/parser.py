"""Parsing of CMake files: the commands, and the errors that CMake would report, where they begin.

The rules are those of cmListFileParser: a command begins a line, `(` is in the same line as its name, brackets are
set apart by blanks.
"""

from __future__ import annotations

import re

from ...lazy_regex import regex
from ...light_dataclasses import dataclass, field
from ...read_problem import ReadProblem
from ...source import Source, Span
from ..syntax_problem import SyntaxProblem
from .lexer import CMakeToken, tokens
from .parse_errors import CONFLICT_START, unclosed, unexpected
from .syntax import CMakeSyntax, CommandArgument, CommandInvocation

BLANK = ("space", "newline", "comment", "bracket comment")
COMMAND_LINE = regex(r"^[ \t]*(?!(?:AND|OR|NOT)\b)[A-Za-z_][A-Za-z0-9_]*[ \t]*\(", re.MULTILINE)
MAX_PROBLEMS = 20
"""After so many the rest of a file is not parsed: each may read to the end."""


def parse(source: Source) -> CMakeSyntax:
    """Parse a text; never raises, and continues after an error with the next line that looks like a command."""
    parser = CMakeParser(source)
    parser.run()
    parser.problems.sort(key=lambda fault: fault.span)
    return CMakeSyntax(source, tuple(parser.commands), tuple(parser.comments), tuple(parser.problems))


@dataclass
class CMakeParser:
    source: Source
    begin: int = 0
    reread: int = 0
    """How many characters were read more than once."""
    commands: list[CommandInvocation] = field(default_factory=list)
    comments: list[Span] = field(default_factory=list)
    problems: list[SyntaxProblem] = field(default_factory=list)

    def run(self) -> None:
        at, text = 0, self.source.text
        while at < len(text) and len(self.problems) < MAX_PROBLEMS and self.reread <= len(text):
            at = self.file(at)

    def file(self, at: int) -> int:
        """Read commands from an offset on; return where to continue after an error, or the end."""
        self.stream, self.begin = tokens(self.source.text, at), at
        fresh = True
        for token in self.stream:
            match token.kind:
                case "newline":
                    fresh = True
                case "space":
                    pass
                case "comment":
                    self.comments.append(token.span)
                case "bracket comment":
                    self.comments.append(token.span)
                    fresh = False
                case "identifier" if fresh:
                    fresh = False
                    if (resume := self.command(token)) is not None:
                        return resume
                case _:
                    return self.fault(token, *unexpected(token, fresh))
        return len(self.source.text)

    def command(self, name: CMakeToken) -> int | None:
        """Read the arguments behind a name; return where to continue after an error, None where there is none."""
        opened = next((token for token in self.stream if token.kind != "space"), None)
        if opened is None or opened.kind != "(":
            return self.fault(name, ReadProblem.CMAKE_NO_PARENTHESIS, name.text)
        arguments: list[CommandArgument] = []
        depth, before = 0, "space"
        for token in self.stream:
            kind = token.kind
            if kind == ")" and not depth:
                span, inner = Span(name.start, token.end), Span(opened.end, token.start)
                self.commands.append(CommandInvocation(name.text.lower(), name.span, span, tuple(arguments), inner))
                return None
            if kind == "bad":
                return self.fault(token, *unclosed(token))
            if before == "newline" and token.text == CONFLICT_START:
                return self.fault(token, ReadProblem.CMAKE_CONFLICT, token.text)
            if lacks_blank(before, kind):
                return self.fault(token, ReadProblem.CMAKE_NO_BLANK)
            before = kind
            if kind not in BLANK:
                depth += (kind == "(") - (kind == ")")
                arguments.append(argument_of(token))
            elif kind in ("comment", "bracket comment"):
                self.comments.append(token.span)
        opening = CMakeToken("bad", name.text + "(", name.start)
        return self.fault(opening, ReadProblem.CMAKE_OPEN_PARENTHESIS, name.text, read_to=len(self.source.text))

    def fault(self, token: CMakeToken, code: ReadProblem, *details: str, read_to: int = 0) -> int:
        """Record a problem; return the offset of the next line that looks like a command.

        The text was read up to the end of the token, or further.
        """
        start = token.start
        if (opening := self.swallowing(start)) is not None:
            start, code, details = opening, ReadProblem.CMAKE_OPEN_QUOTE_BEFORE, ()
        length = len(token.text.split("\n", 1)[0]) if start == token.start else 1
        self.problems.append(SyntaxProblem(Span(start, start + max(length, 1)), code, details))
        again = COMMAND_LINE.search(self.source.text, self.source.text.find("\n", start) + 1 or len(self.source.text))
        resume = again.start() if again else len(self.source.text)
        self.reread += max(0, (read_to or token.end) - resume)
        return resume

    def swallowing(self, before: int) -> int | None:
        """Return the opening quote of the first string that holds a line which looks like a command.

        A quote that was forgotten shows only where the next string begins, often far below.
        """
        last = self.commands[-1].span.end if self.commands else 0
        for token in tokens(self.source.text[: before + 1], max(last, self.begin)):
            if token.kind in ("quoted", "bad") and token.text[0] == '"' and COMMAND_LINE.search(token.text, 1):
                return token.start
        return None


def lacks_blank(before: str, kind: str) -> bool:
    """Return whether a blank that CMake requires is missing: on both sides of a bracket."""
    if "bracket" not in (before, kind) and before != "bracket comment":
        return False
    return kind not in (*BLANK, "(", ")") and before not in ("space", "newline", "comment", "(")


def argument_of(token: CMakeToken) -> CommandArgument:
    kind, text, start = token.kind, token.text, token.start
    span = Span(start, start + len(text))
    if kind == "quoted":
        return CommandArgument("quoted", text[1:-1], span)
    if kind == "bracket":
        width = text.index("[", 1) + 1
        return CommandArgument("bracket", text[width:-width].removeprefix("\n"), span)
    return CommandArgument("paren" if kind in ("(", ")") else "unquoted", text, span)
