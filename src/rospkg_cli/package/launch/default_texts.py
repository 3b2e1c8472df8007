"""What substitutions and conditions of a launch file are with the defaults of its arguments and a bare environment."""

from __future__ import annotations

import ast

from ...languages.python.evaluate.values import Call, Constant, Sequence, Value
from .asked_defaults import FALSE, TRUE, Defaults
from .launch_classes import class_of
from .plain_values import NotKnownError, plain_value
from .python_to_text import text_of
from .text import LaunchText, Literal, Substitution

CLASSES = {
    "EqualsSubstitution": "equals", "NotEqualsSubstitution": "not-equals", "NotSubstitution": "not",
    "AndSubstitution": "and", "OrSubstitution": "or", "AllSubstitution": "all", "AnySubstitution": "any",
}  # fmt: skip


def text_by_default(text: LaunchText, defaults: Defaults) -> str:
    """Return a text; raises NotKnownError."""
    return "".join(part.text if isinstance(part, Literal) else substituted(part, defaults) for part in text.parts)


def substituted(part: Substitution, defaults: Defaults) -> str:
    match part:
        case Substitution(name="var", arguments=(name, *rest)) if name.literal:
            fallback = text_by_default(rest[0], defaults) if rest else None
            return defaults.argument(name.literal, fallback)
        case Substitution(name="env", arguments=(name, default)) if name.literal:
            return defaults.variable(name.literal, text_by_default(default, defaults)) or ""
        case Substitution(name="eval", arguments=(expression, *_)):
            defaults.expression = text_by_default(expression, defaults)
            return str(evaluated(defaults.expression))
        case Substitution(name=name, arguments=arguments) if name in CLASSES.values():
            return str(joint(name, [text_by_default(each, defaults) for each in arguments], defaults))
    raise NotKnownError


def evaluated(expression: str) -> object:
    try:
        return plain_value(ast.parse(expression.strip(), mode="eval").body)
    except (SyntaxError, ValueError, TypeError, RecursionError, MemoryError):
        raise NotKnownError from None


def joint(name: str, words: list[str], defaults: Defaults) -> bool:
    """Return what a substitution of conditions makes of texts."""
    match name, words:
        case "equals" | "not-equals", [left, right]:
            defaults.expression = f"{left!r} == {right!r}"
            alike = left == right or any({left.lower(), right.lower()} <= each for each in (TRUE, FALSE))
            return alike is (name == "equals")
        case "not", [only]:
            return not truth_of(only)
        case "and" | "all", _:
            return all(map(truth_of, words))
        case "or" | "any", _:
            return any(map(truth_of, words))
    raise NotKnownError


def truth_of(word: str) -> bool:
    lower = word.strip().lower()
    if lower not in FALSE | TRUE:
        raise NotKnownError
    return lower in TRUE


def value_by_default(value: Value, defaults: Defaults) -> str:
    """Return the text that launch makes of a value of Python; raises NotKnownError."""
    match value:
        case Sequence(items=[only]):
            return value_by_default(only, defaults)
        case Call() if class_of(value) in CLASSES:
            words = [value_by_default(each.value, defaults) for each in value.arguments]
            return str(joint(CLASSES[class_of(value)], words, defaults))
        case Constant(value=bool(plain)):
            return str(plain)
    return text_by_default(text_of(value), defaults)


def condition_by_default(condition: Call, defaults: Defaults) -> bool:
    """Return whether a condition of Python holds; raises NotKnownError."""
    kind = class_of(condition)
    match kind:
        case "IfCondition" | "UnlessCondition":
            given = condition.get("predicate_expression", 0)
            if given is not None:
                return truth_of(value_by_default(given, defaults)) is (kind == "IfCondition")
        case "LaunchConfigurationEquals" | "LaunchConfigurationNotEquals":
            name, value = (condition.get(*each) for each in (("launch_configuration_name", 0), ("expected_value", 1)))
            asked, expected = (each and text_of(each).literal for each in (name, value))
            if asked and expected is not None:
                defaults.expression = f"{asked} == {expected!r}"
                return (defaults.argument(asked) == expected) is (kind == "LaunchConfigurationEquals")
    raise NotKnownError
