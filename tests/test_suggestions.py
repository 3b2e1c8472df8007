"""Did you mean: what is near, and how much is compared for it."""

from __future__ import annotations

import pytest

from rospkg_cli.suggest import MAX_STEPS, Effort, near_names, nearest, refill

NAMES = [f"some_package_{number}" for number in range(9_000)]


@pytest.mark.parametrize(
    ("word", "names", "meant"),
    [
        ("rclpp", ["rclcpp", "rclpy"], None),
        ("rclccp", ["rclcpp", "std_msgs"], "rclcpp"),
        ("config/robot.yaml", ["config/robots/robot.yaml", "src/a.cpp"], "config/robots/robot.yaml"),
        ("a", ["a"], None),
        ("aaaa", ["bbbb"], None),
    ],
)
def test_the_one_name_that_is_near(word: str, names: list[str], meant: str | None) -> None:
    assert nearest(word, names) == meant


def test_thousands_of_wrong_names_get_no_guess_until_the_next_rule() -> None:
    refill()
    for number in range(100_000):
        if nearest(f"other_package_{number}", NAMES) is None and Effort.left < 0:
            break
    assert Effort.left < 0
    assert near_names("some_package_1x", NAMES) == []
    assert nearest("rclccp", ["rclcpp"]) is None
    refill()
    assert Effort.left == MAX_STEPS
    assert nearest("rclccp", ["rclcpp"]) == "rclcpp"


def test_a_wrong_name_that_is_written_often_is_compared_once() -> None:
    refill()
    assert nearest("rclccp", NAMES) == nearest("rclccp", NAMES)
    once = Effort.left
    assert {nearest("rclccp", NAMES) for _ in range(1_000)} == {nearest("rclccp", NAMES)}
    assert Effort.left == once
