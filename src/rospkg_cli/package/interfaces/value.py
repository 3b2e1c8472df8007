"""Check default values and constants as rosidl_adapter does: with Python's `int` and `float`."""

from __future__ import annotations

import re

from ...ros.interfaces import FLOATS, INTEGERS
from .grammar_problem import GrammarCode, ValueProblem
from .interface_file import FieldType

QUOTES = ('"', "'")


def value_fault(kind: FieldType, value: str) -> ValueProblem | None:
    """Return why a value does not fit a type, or None where it does."""
    if not kind.is_primitive:
        return ValueProblem(GrammarCode.INTERFACE_WITH_DEFAULT, (kind.text,))
    if not kind.is_array:
        return primitive_fault(kind, value)
    if not (value.startswith("[") and value.endswith("]")):
        return ValueProblem(GrammarCode.ARRAY_WITHOUT_BRACKETS, (value.strip("[]"),))
    elements = elements_of(kind, value[1:-1])
    if elements is None:
        return ValueProblem(GrammarCode.ARRAY_ELEMENTS, (value,))
    count = len(elements)
    if kind.size is not None and (count > kind.size if kind.is_bounded else count != kind.size):
        code = GrammarCode.ARRAY_TOO_LONG if kind.is_bounded else GrammarCode.ARRAY_LENGTH
        return ValueProblem(code, (kind.text, str(kind.size), str(count)))
    return next((fault for each in elements if (fault := primitive_fault(kind, each.strip()))), None)


def primitive_fault(kind: FieldType, value: str) -> ValueProblem | None:
    """Check the value of one element."""
    name = kind.base
    if name == "bool":
        fits = value.lower() in ("true", "false", "1", "0")
        return None if fits else ValueProblem(GrammarCode.NO_BOOL, (value,))
    if name in INTEGERS:
        low, high = INTEGERS[name]
        number = integer(value)
        fits = number is not None and low <= number <= high
        return None if fits else ValueProblem(GrammarCode.NO_INTEGER, (value, name, str(low), str(high)))
    if name in FLOATS:
        return None if is_float(value) else ValueProblem(GrammarCode.NO_FLOAT, (value, name))
    return string_fault(kind, value)


def integer(text: str) -> int | None:
    for base in (10, 0):
        try:
            return int(text, base)
        except ValueError:
            continue
    return None


def is_float(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True


def string_fault(kind: FieldType, value: str) -> ValueProblem | None:
    text = unquoted(value)
    for quote in QUOTES:
        if value.startswith(quote) and value.endswith(quote):
            if re.search(rf"(?<!\\){quote}", text):
                return ValueProblem(GrammarCode.QUOTE_IN_STRING, (quote,))
            text = text.replace("\\" + quote, quote)
            break
    if kind.string_bound is not None and len(text) > kind.string_bound:
        return ValueProblem(GrammarCode.STRING_TOO_LONG, (str(len(text)), kind.text, str(kind.string_bound)))
    return None


def unquoted(value: str) -> str:
    """Take off the outer quotes, as rosidl does: only where both are of one kind."""
    quoted = any(value.startswith(quote) and value.endswith(quote) for quote in QUOTES)
    return value[1:-1] if quoted else value


def string_value(value: str) -> str:
    """Return the text of a string's default or of a string constant."""
    for quote in QUOTES:
        if value.startswith(quote) and value.endswith(quote):
            return value[1:-1].replace("\\" + quote, quote)
    return value


def elements_of(kind: FieldType, text: str) -> list[str] | None:
    """Split the text between the brackets; None where rosidl can't."""
    if kind.base not in ("string", "wstring"):
        return text.split(",") if text else []
    found = []
    while text:
        text = text.lstrip(" ")
        if not text or text[0] == ",":
            return None
        if text[0] not in QUOTES:
            element, comma, rest = text.partition(",")
            found.append(element)
            text = comma + rest
        for quote in QUOTES:
            if text.startswith(quote):
                end = closing_quote(text)
                if end is None:
                    return None
                found.append(text[1 : end + 1].replace("\\" + quote, quote))
                text = text[end + 2 :]
        text = text.lstrip(" ").removeprefix(",")
    return found


def closing_quote(text: str) -> int | None:
    """Return the index before the quote that ends the string at the start of a text.

    As rosidl counts it: the character behind an escaped quote is passed over, and of several escaped ones only the
    last counts.
    """
    quote, start, base = text[0], 0, 0
    while start < len(text):
        at = text.find(quote, start + 1)
        if at < 0:
            return None
        if text[at - 1] != "\\":
            return base + at - start - 1
        base, start = at - start + 1, at + 1
    return None
