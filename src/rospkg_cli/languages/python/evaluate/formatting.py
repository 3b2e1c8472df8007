"""Texts made of values: `%`, `str.format`, f-strings, `str()`. An unknown value becomes a part of a PartialText."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping

from ....lazy_regex import regex
from ....light_dataclasses import replace
from ....source import Span
from .conversion import NoPythonValueError, join_texts, to_python
from .limits import STEP, spend
from .values import Constant, PartialText, Sequence, Text, Unknown, Value
from .values import Mapping as MappingValue

PERCENT = regex(
    r"%(?:\((?P<key>[^)]{0,200})\))?(?P<flags>[-#0 +]*)(?P<width>\d*|\*)(?:\.(?P<precision>\d*|\*))?(?P<type>.)"
)
WIDE = regex(r"\d{4}|\*")
"""A width that could make a text of any size."""

CONVERSIONS: Mapping[str, Callable[[object], str]] = {"a": ascii, "r": repr, "s": str}

FIELD = regex(r"(?P<name>\w*)(?P<path>.*)", re.DOTALL)


def as_text(value: Value, span: Span) -> Value:
    """Return the result of str(); an unknown value becomes a part of a PartialText."""
    match value:
        case Text():
            return replace(value, span=span, is_path=False) if value.is_path else value
        case PartialText():
            return replace(value, is_path=False)
        case Constant():
            return format_known(str, value, span)
        case Sequence() | MappingValue():
            return format_known(str, value, span)
    return value


def format_known(function: Callable[[object], str], value: Value, span: Span) -> Value:
    """Return what a function makes of a known value; numbers of many thousand digits have no text."""
    try:
        text = function(to_python(value))
    except NoPythonValueError:
        return Unknown(span, "a part of it can't be evaluated")
    except (ValueError, TypeError, KeyError, ArithmeticError):
        return Unknown(span, "its format can't be evaluated")
    spend(len(text))
    return Text(span, text)


def format_value(value: Value, spec: str, conversion: str, span: Span) -> Value:
    """Return a replacement field's text."""
    if not spec and conversion in ("", "s"):
        return as_text(value, span)
    if WIDE.search(spec):
        return Unknown(span, "its format can't be evaluated")
    convert = CONVERSIONS.get(conversion)
    return format_known(lambda known: format(convert(known) if convert else known, spec), value, span)


def percent_format(left: str, right: Value, span: Span) -> Value | None:
    """Return `left % right`, or None where Python would raise."""
    arguments = list(right.items) if isinstance(right, Sequence) and right.kind == "tuple" else [right]
    arguments.reverse()
    parts: list[Value] = []
    at = 0
    spend(len(left) + len(arguments))
    for match in PERCENT.finditer(left):
        parts.append(Text(span, left[at : match.start()]))
        at = match.end()
        if match["type"] == "%":
            parts.append(Text(span, "%"))
            continue
        if match["key"] is not None:
            value = right.get(match["key"]) if isinstance(right, MappingValue) and not right.rest else None
        else:
            value = arguments.pop() if arguments else None
        if value is None:
            return None
        parts.append(format_field(match, value, span))
    if arguments and not isinstance(right, MappingValue):
        return None
    return join_texts([*parts, Text(span, left[at:])], span)


def format_field(match: re.Match[str], value: Value, span: Span) -> Value:
    if match["type"] == "s" and not (match["flags"] or match["width"] or match["precision"]):
        return as_text(value, span)
    if WIDE.search(match["width"] + (match["precision"] or "")):
        return Unknown(span, "its format can't be evaluated")
    form = match.group().replace(f"({match['key']})", "") if match["key"] is not None else match.group()
    return format_known(lambda known: form % (known,), value, span)


def brace_format(text: str, positional: list[Value], named: Callable[[str], Value | None], span: Span) -> Value | None:
    """Return `text.format(…)`, or None where Python would raise or the fields are more than names."""
    parts: list[Value] = []
    count = 0
    spend(len(text))
    from string import Formatter

    try:
        for literal, field, spec, conversion in Formatter().parse(text):
            spend(STEP)
            parts.append(Text(span, literal))
            if field is None:
                continue
            match = FIELD.fullmatch(field)
            if match is None or match["path"] or "{" in (spec or ""):
                return None
            name = match["name"]
            if not name:
                name, count = str(count), count + 1
            if name.isdecimal():
                value = positional[int(name)] if len(name) < 5 and int(name) < len(positional) else None
            else:
                value = named(name)
            if value is None:
                return None
            parts.append(format_value(value, spec or "", conversion or "", span))
    except ValueError:
        return None
    return join_texts(parts, span)
