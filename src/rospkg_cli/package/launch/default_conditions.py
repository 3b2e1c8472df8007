"""What a launch file does only where an argument has another value than its default."""

from __future__ import annotations

import ast
from collections.abc import Iterator, Mapping

from ...languages.python.evaluate.values import Call, Sequence, Value
from ...languages.python.nodes import nodes_of
from ...light_dataclasses import dataclass
from ...source import Span
from .argument_defaults import literal_defaults
from .entity import Entity
from .launch_classes import class_of
from .launch_file import LaunchFile
from .python_to_text import text_of
from .substitution import SubstitutionError, parse_text
from .text import LaunchText, Literal, Substitution

FALSE = frozenset({"false", "0"})
TRUE = frozenset({"true", "1"})
MAX_DEPTH = 8


@dataclass(frozen=True, slots=True)
class OffByDefault:
    """A part of a launch file, and the argument that turns it on: `sim:=true`."""

    span: Span
    argument: str


def off_by_default(file: LaunchFile) -> Iterator[OffByDefault]:
    """Yield the actions whose condition is false for the defaults of the file's own arguments, with all inside."""
    defaults = literal_defaults(file.arguments, file.assigned)
    if not defaults:
        return
    for call in file.evaluated.calls if file.evaluated else ():
        condition = call.get("condition")
        found = false_call(condition, defaults) if isinstance(condition, Call) else None
        for span in spans_of(call) if found else ():
            yield OffByDefault(span, found or "")
    if file.root is not None:
        yield from off_entities(file.root, defaults)


def off_entities(entity: Entity, defaults: Mapping[str, str]) -> Iterator[OffByDefault]:
    for name in ("if", "unless"):
        written = entity.attributes.get(name)
        if written is not None:
            try:
                found = false_text(parse_text(written), defaults, wanted=name == "if")
            except SubstitutionError:
                continue
            if found:
                yield OffByDefault(entity.span, found)
                return
    for child in entity.children:
        yield from off_entities(child, defaults)


def spans_of(call: Call) -> Iterator[Span]:
    """Yield the spans of an action, and of the actions in its lists."""
    waiting: list[tuple[Value, int]] = [(call, 0)]
    while waiting:
        value, depth = waiting.pop()
        if isinstance(value, Call):
            yield value.span
            given = value.get("actions", 0) if class_of(value) == "GroupAction" else value.get("entities")
            waiting += [(given, depth)] if given is not None else []
        elif isinstance(value, Sequence) and depth < MAX_DEPTH:
            waiting += [(item, depth + 1) for item in value.items]


def false_call(condition: Call, defaults: Mapping[str, str]) -> str | None:
    """Return the argument that makes a condition true which is false by default; None for any other condition."""
    match class_of(condition):
        case "IfCondition" | "UnlessCondition" as kind:
            given = condition.get("predicate_expression", 0)
            return None if given is None else false_text(text_of(given), defaults, wanted=kind == "IfCondition")
        case "LaunchConfigurationEquals":
            name, value = (condition.get(*each) for each in (("launch_configuration_name", 0), ("expected_value", 1)))
            asked = text_of(name).literal if name is not None else None
            expected = text_of(value).literal if value is not None else None
            if asked and expected and defaults.get(asked, expected) != expected:
                return f"{asked}:={expected}"
    return None


def false_text(text: LaunchText, defaults: Mapping[str, str], *, wanted: bool) -> str | None:
    """Return the argument by which a text becomes what is wanted, where the defaults make it the opposite."""
    match text.parts:
        case (Substitution(name="var", arguments=(name, *_)),):
            asked = name.literal or ""
            value = defaults.get(asked, "").lower()
            return f"{asked}:={str(wanted).lower()}" if value in (FALSE if wanted else TRUE) else None
        case (Substitution(name="eval", arguments=(expression, *_)),):
            asked = next((s.arguments[0].literal or "" for s in expression.substitutions("var") if s.arguments), "")
            written = with_defaults(expression, defaults)
            result = None if written is None else value_of(written)
            return f"{asked}:={other_value(written or '', defaults.get(asked, ''))}" if result is (not wanted) else None
    return None


def with_defaults(text: LaunchText, defaults: Mapping[str, str]) -> str | None:
    """Return a text with the default of every argument; None where it holds anything else."""
    pieces = []
    for part in text.parts:
        if isinstance(part, Literal):
            pieces.append(part.text)
        elif part.name == "var" and part.arguments and (part.arguments[0].literal or "") in defaults:
            pieces.append(defaults[part.arguments[0].literal or ""])
        else:
            return None
    return "".join(pieces)


def other_value(expression: str, default: str) -> str:
    """Return a string of an expression that is not the default, `…` where there is none."""
    strings = [n.value for n in nodes_of(ast.parse(expression.strip(), mode="eval")) if isinstance(n, ast.Constant)]
    return next((each for each in strings if isinstance(each, str) and each and each != default), "…")


def value_of(expression: str) -> bool | None:
    """Return the truth of comparisons of strings; None for anything else."""
    try:
        return truth(ast.parse(expression.strip(), mode="eval").body)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return None


def truth(node: ast.expr) -> bool | None:
    match node:
        case ast.Constant(value=bool(value)):
            return value
        case ast.Name(id=name) if name.lower() in ("true", "false"):
            return name.lower() == "true"
        case ast.UnaryOp(op=ast.Not(), operand=operand):
            inside = truth(operand)
            return None if inside is None else not inside
        case ast.Compare(left=ast.Constant(value=left), ops=[operator], comparators=[ast.Constant(value=right)]):
            return {ast.Eq: left == right, ast.NotEq: left != right}.get(type(operator))
        case ast.BoolOp(op=operator, values=values):
            found = [truth(each) for each in values]
            decides = isinstance(operator, ast.Or)
            return decides if decides in found else None if None in found else not decides
    return None
