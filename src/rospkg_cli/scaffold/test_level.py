"""How much of a package is tested: everything that ament tests, what needs no ROS, or nothing."""

from __future__ import annotations

from ..suggest import did_you_mean
from . import ScaffoldError
from .answers import Answers
from .launch_format import activated, launch_packages
from .requested_node import RequestedNode

TEST_LEVELS = {
    "ament": "linters, the nodes' logic and a launch test",
    "minimal": "what needs neither ROS nor ament",
    "none": "nothing",
}


def test_level(asked: str) -> str:
    """Return which tests are written; raises ScaffoldError."""
    if asked not in TEST_LEVELS:
        raise ScaffoldError(
            f"there are no tests `{asked}`{did_you_mean(asked, TEST_LEVELS)}; known: {', '.join(TEST_LEVELS)}"
        )
    return asked


def has_linters(answers: Answers) -> bool:
    """Return whether ament's linters are among the tests."""
    return answers.tests == "ament"


def has_launch_test(answers: Answers) -> bool:
    """Return whether a test starts the launch file."""
    return answers.tests == "ament" and bool(answers.launch) and bool(answers.nodes)


def launch_test_packages(answers: Answers) -> list[str]:
    """Return what that test needs and the launch file does not."""
    if not has_launch_test(answers):
        return []
    return [name for name in ("launch", "launch_testing") if name not in launch_packages(answers)]


def tested_logics(answers: Answers, language: str) -> list[str]:
    """Return the modules without ROS that have tests."""
    return [] if answers.tests == "none" else list(answers.logics_in(language))


def first_words(answers: Answers, node: RequestedNode) -> str:
    """Return what shows in the log that the launch file brought a node up."""
    return "Hello 1" if node in activated(answers) else node.kind.says
