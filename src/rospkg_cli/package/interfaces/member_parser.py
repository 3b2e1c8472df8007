"""Parse one line of a message that declares a field or a constant."""

from __future__ import annotations

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...ros.interfaces import PRIMITIVES, STRINGS
from ...source import Span
from .comments import InterfaceComment
from .escape import escape_fault
from .grammar_problem import GrammarCode, GrammarProblem, ValueProblem
from .interface_file import FieldType, Member
from .type_parser import TypeProblemError, parse_type
from .value import QUOTES, string_value, value_fault

NAME = regex(r"[A-Za-z0-9_-]+")
"""The form of a name; rosidl may still refuse it."""


@dataclass(frozen=True, slots=True)
class InterfaceLine:
    """A line without white space at its end, with blanks for tabs; in the file it may be longer."""

    text: str
    at: int

    def span(self, start: int, end: int) -> Span:
        return Span(self.at + start, self.at + end)


class MemberReader:
    """Reads lines that declare something, and keeps the problems of all of them."""

    def __init__(self) -> None:
        self.problems: list[GrammarProblem] = []

    def problem(self, span: Span, code: GrammarCode, *details: str, repair: str | None = None) -> None:
        self.problems.append(GrammarProblem(span, code, details, repair, span if repair is not None else None))

    def member(self, line: InterfaceLine, comment: InterfaceComment) -> Member | None:
        """Return the field or constant that a line declares; None, and a problem, where it declares none."""
        text = line.text
        start = len(text) - len(text.lstrip(" "))
        if start:
            self.problem(line.span(0, start), GrammarCode.LEADING_BLANK, repair="")
        kind, _, rest = text[start:].partition(" ")
        rest_at = len(text) - len(rest.lstrip())
        if not rest.strip():
            self.problem(line.span(start, len(text)), GrammarCode.ONE_WORD, text[start:])
            return None
        if "=" in rest:
            return self.constant(line, line.span(start, start + len(kind)), rest_at, comment)
        return self.field(line, line.span(start, start + len(kind)), rest_at, comment)

    def field(self, line: InterfaceLine, kind_span: Span, at: int, comment: InterfaceComment) -> Member | None:
        kind = self.type_at(line, kind_span)
        name, _, value = line.text[at:].partition(" ")
        value = value.lstrip()
        if kind is None or not self.is_name(line, at, name, value):
            return None
        value_span = line.span(len(line.text) - len(value), len(line.text))
        if value:
            self.check_value(kind, value, value_span, comment)
        return Member(kind, name, line.span(at, at + len(name)), False, value or None, value_span)

    def constant(self, line: InterfaceLine, kind_span: Span, at: int, comment: InterfaceComment) -> Member | None:
        name, _, value = line.text[at:].partition("=")
        name, value = name.rstrip(), value.lstrip()
        span = line.span(at, at + len(name))
        if not NAME.fullmatch(name):
            is_text = any(quote in name for quote in QUOTES)
            code = GrammarCode.CONSTANT_WITH_QUOTE if is_text else GrammarCode.DEFAULT_WITH_EQUALS_SIGN
            self.problem(line.span(at, len(line.text)), code)
            return None
        kind = self.type_at(line, kind_span)
        if kind is None:
            return None
        if kind.text not in PRIMITIVES:
            self.problem(kind.span, GrammarCode.CONSTANT_TYPE, kind.text)
            return None
        value_span = line.span(len(line.text) - len(value), len(line.text))
        self.check_value(kind, value, value_span, comment)
        return Member(kind, name, span, True, value, value_span)

    def type_at(self, line: InterfaceLine, span: Span) -> FieldType | None:
        try:
            return parse_type(line.text[span.start - line.at : span.end - line.at], span.start)
        except TypeProblemError as error:
            self.problems.append(error.problem)
            return None

    def is_name(self, line: InterfaceLine, at: int, name: str, value: str) -> bool:
        if NAME.fullmatch(name):
            return True
        span = line.span(at, at + len(name))
        if name.startswith("["):
            self.problem(span, GrammarCode.BRACKETS_AT_NAME, line.text.split()[0], name)
        elif NAME.fullmatch(name[:-1]) and name[-1] in ";," and not value:
            end = line.span(at + len(name) - 1, at + len(name))
            self.problem(end, GrammarCode.SIGN_AT_END, name[-1], repair="")
        else:
            self.problem(span, GrammarCode.FIELD_NAME, name)
        return False

    def check_value(self, kind: FieldType, value: str, span: Span, comment: InterfaceComment) -> None:
        fault = value_fault(kind, value)
        if kind.base in STRINGS and is_open(value) and value[0] in comment.text:
            span = Span(span.start, comment.at + comment.text.index(value[0]) + 1)
            fault = ValueProblem(GrammarCode.NUMBER_SIGN_IN_STRING, (value,))
        elif fault is None and kind.base in STRINGS:
            fault = text_fault(kind, value)
        if fault:
            self.problem(span, fault.code, *fault.details)


def is_open(value: str) -> bool:
    """Return whether a value opens a quote and does not close it."""
    return value[:1] in QUOTES and (len(value) == 1 or value[-1] != value[0])


def text_fault(kind: FieldType, value: str) -> ValueProblem | None:
    """Return why rosidl can't write a string into the .idl file."""
    if kind.is_array:
        ascii_only = all(ord(char) < 128 or not char.isprintable() for char in value)
        return None if ascii_only else ValueProblem(GrammarCode.STRING_ARRAY_NOT_ASCII)
    if escape_fault(string_value(value)):
        return ValueProblem(GrammarCode.BACKSLASH_IN_STRING, (value,))
    return None
