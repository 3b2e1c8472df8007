"""Did you mean: what is near, and how much is compared for it."""

from __future__ import annotations

import pytest

from rospkg_cli.suggest import MAX_STEPS, Effort, is_slip, near_names, nearest, refill, slips

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


@pytest.mark.parametrize(
    ("word", "name", "expected"),
    [
        ("arm_ocntroller.launch.py", "arm_controller.launch.py", True),
        ("arm_contoller", "arm_controller", True),
        ("taalker", "talker", True),
        ("maain", "main", True),
        ("arm_controllers", "arm_controller", False),
        ("arm_controlle", "arm_controller", False),
        ("camera_lift", "camera_left", False),
        ("xcamera", "camera", False),
        ("amera", "camera", False),
        ("camera_l", "camera_ll", False),
        ("robt1", "robot1", False),
        ("tlaekr", "talker", False),
        ("mian_arm_pose", "main_amr_pose", False),
        ("controller", "arm_controller", False),
        ("talker", "talker", False),
    ],
)
def test_slips_of_the_fingers(word: str, name: str, expected: bool) -> None:
    assert is_slip(word, name) == expected
    assert slips(word, [name, "something_else"]) == [name] * expected


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
