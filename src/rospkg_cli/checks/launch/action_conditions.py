"""Conditions of actions in a launch file, and whether they hold with the defaults of the arguments."""

from __future__ import annotations

from collections.abc import Container, Iterator, Mapping
from contextlib import suppress

from ...languages.python.evaluate.values import Call, Constant, Value
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.launch.argument_defaults import literal_defaults
from ...package.launch.asked_defaults import Defaults
from ...package.launch.default_conditions import spans_of
from ...package.launch.default_texts import condition_by_default
from ...package.launch.launch_classes import class_of
from ...package.launch.launch_file import LaunchFile
from ...package.launch.plain_values import NotKnownError, truth_of_text
from ...package.launch.python_to_text import text_of
from ...package.launch.text import LaunchText, Substitution
from ...source import Span
from .python_expressions import filled

TRUTHS = {"true": True, "1": True, "false": False, "0": False}
"""What IfCondition takes, in lower case. (launch/conditions/evaluate_condition_expression_impl.py)"""
GIVING = ("declare", "define", "pass")
"""What gives a launch configuration a value. (LaunchEvent.kind)"""
NEGATED = {"IfCondition": False, "UnlessCondition": True, "if": False, "unless": True}
VARIABLE = regex(r"\$\(var ([^()\s]+)\)")


@dataclass(frozen=True, slots=True)
class GuardedAction:
    """An action, its condition, and what that is with the defaults of the arguments; None where it is unknown."""

    around: Span
    written: Span
    holds: bool | None

    def guards(self, span: Span) -> bool:
        """Return whether a place is only visited where the condition holds, which is itself always evaluated."""
        return self.around.contains(span) and not self.written.contains(span)


def conditional(file: LaunchFile) -> Iterator[GuardedAction]:
    """Yield the conditions of actions that are not true by default, for each action that they are about."""
    defaults, given = literal_defaults(file.arguments, file.assigned), given_in(file)
    for call in file.evaluated.calls if file.evaluated else ():
        condition = call.get("condition")
        holds = True if condition is None else holds_in_python(condition, defaults, given)
        if condition is not None and holds is not True:
            yield from (GuardedAction(span, condition.span, holds) for span in spans_of(call))
    for entity in file.root.walk() if file.root else ():
        for name in ("if", "unless"):
            written = entity.attributes.get(name)
            holds = True if written is None else holds_in_entity(name, written.text.strip(), defaults)
            if written is not None and holds is not True:
                yield GuardedAction(entity.span, written.span, holds)


def given_in(file: LaunchFile) -> frozenset[str | None]:
    """Return the launch configurations that a file may give a value; None for names that are not known."""
    names = [text.literal for text in (*(each.name for each in file.arguments), *file.assigned)]
    return frozenset((*names, *(each.name for each in file.events or () if each.kind in GIVING and each.name)))


def holds_in_python(condition: Value, defaults: Mapping[str, str], given: Container[str | None]) -> bool | None:
    """Return whether the condition of an action holds, as far as the defaults say."""
    if isinstance(condition, Constant) and condition.value is None:
        return True
    if not isinstance(condition, Call) or class_of(condition) not in NEGATED:
        return None
    value = condition.get("predicate_expression", 0)
    text = None if value is None else text_of(value)
    found = None if text is None else truth(text, defaults)
    if text is not None and found is None and is_off_inline(condition, text, defaults, given):
        return False
    return None if found is None else found is not NEGATED[class_of(condition)]


def is_off_inline(condition: Call, text: LaunchText, defaults: Mapping[str, str], given: Container[str | None]) -> bool:
    """Return whether a condition is false where nothing is set: `LaunchConfiguration('nav', default='false')`.

    It never says that one holds: a file that is included, or includes this one, may set what this one only reads.
    """
    asked = [each.arguments for each in text.substitutions("var")]
    names = {arguments[0].literal for arguments in asked if arguments}
    is_inline = any(len(each) > 1 for each in asked)
    if not is_inline or None in given or any(name in given and name not in defaults for name in names):
        return False
    with suppress(NotKnownError):
        return not condition_by_default(condition, Defaults(defaults))
    return False


def holds_in_entity(name: str, text: str, defaults: Mapping[str, str]) -> bool | None:
    found = VARIABLE.fullmatch(text)
    value = TRUTHS.get((defaults.get(found.group(1), "") if found else text).lower())
    return None if value is None else value is not NEGATED[name]


def truth(text: LaunchText, defaults: Mapping[str, str]) -> bool | None:
    """Return what a condition is with these defaults: of an argument, a literal, or a comparison of both."""
    match text.parts:
        case (Substitution(name="eval", arguments=(expression,)),):
            names = (each.arguments[0].literal for each in expression.substitutions("var") if each.arguments)
            known = all(name in defaults for name in names) and not any(expression.substitutions("?", "env"))
            return truth_of_text(filled(expression, None, defaults)) if known else None
        case (Substitution(name="var", arguments=(name, *_)),):
            return TRUTHS.get(defaults.get(name.literal or "", "").lower())
    return TRUTHS.get((text.literal or "").lower())
