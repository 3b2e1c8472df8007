"""The type of a field, read as rosidl_adapter reads it: `int32`, `string<=10`, `geometry_msgs/Point[<=5]`."""

from __future__ import annotations

from ...ros.interfaces import FOREIGN_TYPES, PACKAGE_NAME, PRIMITIVES, ROS1_TYPES, valid_interface_name
from ...source import Span
from .interface_file import FieldType, GrammarProblem

BOUND = "<="


class TypeProblemError(Exception):
    """The text is no type."""

    def __init__(self, problem: GrammarProblem) -> None:
        super().__init__(problem.message)
        self.problem = problem


def parse_type(text: str, at: int) -> FieldType:
    """Parse the text of a type at an offset; raises TypeProblemError."""
    span = Span(at, at + len(text))
    base, array, size, bounded = text, False, None, False
    if text.endswith("]"):
        base, opening, inside = text[:-1].rpartition("[")
        if not opening:
            raise fail(span, f"`{text}` has a `]` without a `[`; an array is `{text[:-1]}[]`")
        array, bounded = True, inside.startswith(BOUND)
        size = positive(inside.removeprefix(BOUND) if bounded else inside) if inside else None
        if inside and size is None:
            raise fail(span, f"`{inside}` is no size of an array: write `{base}[]`, `{base}[3]` or `{base}[<=3]`")
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
        raise fail(span, f"`{base}` needs a whole number above 0 behind `{BOUND}`: `{string}<=10`")
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
        better = FOREIGN_TYPES[base]
        raise fail(span, f"`{base}` is no type of rosidl; the build stops here: write `{better}`", better, False)
    if base in ("time", "duration"):
        better = ROS1_TYPES[base]
        raise fail(span, f"`{base}` is a type of ROS 1; rosidl can't generate it: write `{better}`", better)
    parts = base.split("/")
    if len(parts) == 3 and parts[1] in ("msg", "srv", "action"):
        better = f"{parts[0]}/{parts[2]}"
        raise fail(span, f"rosidl refuses `{base}`: in an interface file it is written `{better}`", better)
    if len(parts) > 2:
        raise fail(span, f"`{base}` is no type: write `package/Name`")
    if len(parts) == 2 and not PACKAGE_NAME.fullmatch(parts[0]):
        raise fail(span, f"`{parts[0]}` in `{base}` can't be the name of a package: lower case, digits and single `_`")
    if not valid_interface_name(parts[-1]):
        raise fail(span, explain(parts[-1]))
    return ("" if len(parts) == 1 else parts[0]), parts[-1]


def explain(name: str) -> str:
    if "[" in name or "]" in name:
        return f"`{name}` is no type: an array has one pair of brackets, without spaces: `int32[]`, `int32[3]`"
    return f"`{name}` is no type: primitive types are `bool`, `int32`, `float64`, `string` …; others are CamelCase"


def fail(span: Span, message: str, repair: str | None = None, certain: bool = True) -> TypeProblemError:
    title = f"write `{repair}`" if repair else ""
    return TypeProblemError(GrammarProblem(span, message, repair, span if repair else None, title, certain))
