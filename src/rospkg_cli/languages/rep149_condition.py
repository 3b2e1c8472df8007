"""Whether conditions of package.xml (REP-149) hold.

Only the variables of the ROS environment have known values; a condition that depends on any other is unknown: None.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from .rep149_syntax import parse_condition
from .syntax_problem import SyntaxProblemError

Environments = Sequence[Mapping[str, str]]
"""The variables of each target, as `Targets.environments` gives them."""


def evaluate_condition(text: str | None, variables: Mapping[str, str]) -> bool | None:
    """Return whether a condition holds; None where that is unknown, or where the text is no condition.

    Without a condition (None) the answer is True.
    """
    if text is None:
        return True
    try:
        return parse_condition(text).holds(variables)
    except SyntaxProblemError:
        return None


def may_hold(text: str | None, environments: Environments) -> bool:
    """Return whether a condition may hold for one of the targets."""
    return text is None or any(evaluate_condition(text, variables) is not False for variables in environments)


def always_holds(text: str | None, environments: Environments) -> bool:
    """Return whether a condition certainly holds for every target."""
    return text is None or all(evaluate_condition(text, variables) for variables in environments)


def can_hold_together(one: str | None, other: str | None, environments: Environments) -> bool:
    """Return whether two conditions certainly hold at once for one target; equal ones do so wherever they hold."""
    if one == other:
        return may_hold(one, environments)
    return any(evaluate_condition(one, each) and evaluate_condition(other, each) for each in environments)
