"""Conditions of REP-149, beside what catkin_pkg (colcon, rosdep, bloom) makes of them."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from catkin_pkg.condition import evaluate_condition
from hypothesis import given
from hypothesis import strategies as st

from rospkg_cli.languages.rep149_condition import can_hold_together, may_hold
from rospkg_cli.languages.rep149_syntax import parse_condition
from rospkg_cli.languages.syntax_problem import SyntaxProblemError
from rospkg_cli.ros.distros import Targets

ROS = Targets(("humble", "jazzy")).environments()
pytestmark = pytest.mark.filterwarnings("ignore::DeprecationWarning")  # of pyparsing, in catkin_pkg
VARIABLES = {"ROS_VERSION": "2", "ROS_DISTRO": "jazzy"}
OPERAND = st.sampled_from(["$ROS_VERSION", "$ROS_DISTRO", "1", "2", "jazzy", "foo-bar_1", '"3.8"', "'a b'", '"it\'s"'])
OPERATOR = st.sampled_from(["==", "!=", "<", "<=", ">", ">="])
COMPARISON = st.builds(lambda a, o, b, s: f"{a}{s}{o}{s}{b}", OPERAND, OPERATOR, OPERAND, st.sampled_from(["", " "]))
CONDITION = st.recursive(
    COMPARISON,
    lambda inner: st.one_of(
        inner.map(lambda c: f"({c})"),
        st.builds(lambda a, w, b: f"{a} {w} {b}", inner, st.sampled_from(["and", "or"]), inner),
    ),
    max_leaves=5,
)
PIECES = st.lists(
    st.sampled_from(
        ["$ROS_VERSION", "$", "2", "'x'", '"', "==", "=", "!=", "<", "and", "or", "not", "(", ")", "3.8", " "]
    ),
    max_size=7,
).map(" ".join)


@given(CONDITION)
def test_a_condition_means_what_catkin_pkg_says(text: str) -> None:
    assert parse_condition(text).holds(VARIABLES) == evaluate_condition(text, VARIABLES)


@given(PIECES)
def test_what_catkin_pkg_refuses_is_refused(text: str) -> None:
    assert outcome(lambda: parse_condition(text).holds(VARIABLES)) == outcome(
        lambda: evaluate_condition(text, VARIABLES)
    )


def outcome(evaluate: Callable[[], bool | None]) -> bool | str | None:
    try:
        return evaluate()
    except ValueError:  # as SyntaxProblemError is one
        return "refused"


@pytest.mark.parametrize(
    "text, at",
    [
        ("$ROS_VERSION = 2", 13),
        ("$ROS_VERSION", 12),
        ("3.8 == $X", 1),
        ("not $A == 1", 4),
        ("", 0),
        ("($A == 1", 8),
        ("$A == 1)", 7),
    ],
)
def test_a_fault_is_shown_where_it_is(text: str, at: int) -> None:
    with pytest.raises(SyntaxProblemError) as caught:
        parse_condition(text)
    assert caught.value.problem.span.start == at


def test_deep_parentheses_are_refused() -> None:
    with pytest.raises(SyntaxProblemError, match="CONDITION_DEPTH"):
        parse_condition("(" * 5000)


def test_an_unknown_variable_makes_a_condition_unknown() -> None:
    assert parse_condition("$MY_ROBOT == 1").holds(VARIABLES) is None
    assert parse_condition("$MY_ROBOT == 1 and $ROS_VERSION == 1").holds(VARIABLES) is False
    assert parse_condition("$MY_ROBOT == 1 or $ROS_VERSION == 2").holds(VARIABLES) is True


def test_a_condition_is_possible_where_it_holds_for_one_target_or_cannot_be_told() -> None:
    assert may_hold(None, ROS)
    assert may_hold("$ROS_DISTRO == humble", ROS)
    assert may_hold("$MY_ROBOT == 1", ROS)
    assert may_hold("$ROS_VERSION = 2", ROS)
    assert not may_hold("$ROS_DISTRO == foxy", ROS)


def test_two_conditions_hold_together() -> None:
    assert can_hold_together(None, "$ROS_VERSION == 2", ROS)
    assert can_hold_together("$MY_ROBOT == 1", "$MY_ROBOT == 1", ROS)
    assert not can_hold_together("$ROS_DISTRO == humble", "$ROS_DISTRO == jazzy", ROS)
    assert not can_hold_together(None, "$MY_ROBOT == 1", ROS)
    assert not can_hold_together("$ROS_VERSION == 1", "$ROS_VERSION == 1", ROS)
