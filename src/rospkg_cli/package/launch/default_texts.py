"""What substitutions and conditions of a launch file are with the defaults of its arguments and a bare environment."""

from __future__ import annotations

import ast
from collections.abc import Mapping

from ...languages.python.evaluate.values import Call, Constant, Sequence, Value
from ...light_dataclasses import dataclass, field
from .launch_classes import class_of
from .plain_values import NotKnownError, plain_value
from .python_to_text import text_of
from .text import LaunchText, Literal, Substitution

FALSE = frozenset({"false", "0"})
TRUE = frozenset({"true", "1"})
OF_ROS = frozenset({"ROS_DISTRO", "ROS_VERSION", "AMENT_PREFIX_PATH", "HOME", "USER", "PATH", "PWD", "DISPLAY"})
"""Variables that nearly every environment has."""
CLASSES = {
    "EqualsSubstitution": "equals", "NotEqualsSubstitution": "not-equals", "NotSubstitution": "not",
    "AndSubstitution": "and", "OrSubstitution": "or", "AllSubstitution": "all", "AnySubstitution": "any",
}  # fmt: skip


@dataclass
class Defaults:
    """The defaults, and what was asked for so far."""

    arguments: Mapping[str, str]
    asked: dict[str, str] = field(default_factory=dict)
    """Each argument (`sim:=`) or variable (`SIM=`) that a value depends on, with its default."""
    distribution: str = ""
    """The distribution of ROS; "" where it is not known."""
    expression: str = ""
    """The last expression of Python that was evaluated, or what would say the same."""

    def argument(self, name: str, fallback: str | None = None) -> str:
        found = self.arguments.get(name, fallback)
        if found is None:
            raise NotKnownError
        self.asked.setdefault(f"{name}:=", found)
        return found

    def variable(self, name: str, fallback: str | None) -> str | None:
        if name == "ROS_DISTRO" and self.distribution:
            self.asked.setdefault(f"{name}=", self.distribution)
            return self.distribution
        if name in OF_ROS:
            raise NotKnownError
        self.asked.setdefault(f"{name}=", fallback or "")
        return fallback

    def other(self) -> str:
        """Return the first thing that was asked for, with a value that is not its default: `sim:=true`; "" for none."""
        if not self.asked:
            return ""
        name, default = next(iter(self.asked.items()))
        found = compared_with(self.expression, default)
        opposite = str(default.lower() in FALSE).lower() if default.lower() in FALSE | TRUE else "…"
        return f"{name}{found or opposite}"


def compared_with(expression: str, default: str) -> str:
    """Return a text that an expression compares something with and that is not the default; "" for none."""
    try:
        nodes = list(ast.walk(ast.parse(expression.strip(), mode="eval")))
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return ""
    operands = [each for node in nodes if isinstance(node, ast.Compare) for each in (node.left, *node.comparators)]
    lists = [item for each in operands if isinstance(each, ast.List | ast.Tuple | ast.Set) for item in each.elts]
    words = [each.value for each in (*operands, *lists) if isinstance(each, ast.Constant)]
    return next((word for word in words if isinstance(word, str) and word not in ("", default)), "")


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
