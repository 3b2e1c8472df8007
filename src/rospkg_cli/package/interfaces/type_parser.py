"""The type of a field, read as rosidl_adapter reads it: `int32`, `string<=10`, `geometry_msgs/Point[<=5]`."""

from __future__ import annotations

from ...ros.interfaces import FOREIGN_TYPES, PACKAGE_NAME, PRIMITIVES, ROS1_TYPES, valid_interface_name
from ...source import Span
from .grammar_problem import GrammarCode, GrammarProblem
from .interface_file import FieldType

BOUND = "<="


class TypeProblemError(Exception):
    """The text is no type."""

    def __init__(self, problem: GrammarProblem) -> None:
        super().__init__(problem.code)
        self.problem = problem


def parse_type(text: str, at: int) -> FieldType:
    """Parse the text of a type at an offset; raises TypeProblemError."""
    span = Span(at, at + len(text))
    base, array, size, bounded = text, False, None, False
    if text.endswith("]"):
        base, opening, inside = text[:-1].rpartition("[")
        if not opening:
            raise fail(span, GrammarCode.BRACKET_NOT_OPENED, text, text[:-1])
        array, bounded = True, inside.startswith(BOUND)
        size = positive(inside.removeprefix(BOUND) if bounded else inside) if inside else None
        if inside and size is None:
            raise fail(span, GrammarCode.ARRAY_SIZE, inside, base)
    for string in ("string", "wstring"):
        if base.startswith(string + BOUND):
            return bounded_string(base, string, span, (array, size, bounded), text)
    base_span = Span(at, at + len(base))
    if base in PRIMITIVES:
        return FieldType(text, span, base, base_span, "", True, None, array, size, bounded)
    package, name = nested(base, base_span)
    return FieldType(text, span, name, base_span, package, False, None, array, size, bounded)


def bounded_string(base: str, string: str, span: Span, brackets: tuple[bool, int | None, bool], text: str) -> FieldType:
    bound = positive(base[len(string + BOUND) :])
    if bound is None:
        raise fail(span, GrammarCode.STRING_BOUND, base, string)
    return FieldType(text, span, string, Span(span.start, span.start + len(string)), "", True, bound, *brackets)


def positive(text: str) -> int | None:
    """Return a number above 0 as rosidl reads it (Python's `int`), else None."""
    try:
        number = int(text)
    except ValueError:
        return None
    return number if number > 0 else None


def nested(base: str, span: Span) -> tuple[str, str]:
    """Return the package ("" for the own one) and the name of an interface type; raises TypeProblemError."""
    if base in FOREIGN_TYPES and base[0].islower():
        raise better(span, GrammarCode.FOREIGN_TYPE, base, FOREIGN_TYPES[base], certain=False)
    if base in ("time", "duration"):
        raise better(span, GrammarCode.ROS1_TYPE, base, ROS1_TYPES[base])
    parts = base.split("/")
    if len(parts) == 3 and parts[1] in ("msg", "srv", "action"):
        raise better(span, GrammarCode.TYPE_WITH_FOLDER, base, f"{parts[0]}/{parts[2]}")
    if len(parts) > 2:
        raise fail(span, GrammarCode.TYPE_WITH_FOLDERS, base)
    if len(parts) == 2 and not PACKAGE_NAME.fullmatch(parts[0]):
        raise fail(span, GrammarCode.PACKAGE_NAME, parts[0], base)
    if not valid_interface_name(parts[-1]):
        nested_array = "[" in parts[-1] or "]" in parts[-1]
        raise fail(span, GrammarCode.ARRAY_OF_ARRAYS if nested_array else GrammarCode.TYPE_NAME, parts[-1])
    return ("" if len(parts) == 1 else parts[0]), parts[-1]


def fail(span: Span, code: GrammarCode, *details: str) -> TypeProblemError:
    return TypeProblemError(GrammarProblem(span, code, details))


def better(span: Span, code: GrammarCode, written: str, repair: str, certain: bool = True) -> TypeProblemError:
    return TypeProblemError(GrammarProblem(span, code, (written, repair), repair, span, certain))
