"""How much of a package is tested: everything that ament tests, what needs no ROS, or nothing."""

from __future__ import annotations

from ..suggest import did_you_mean
from . import ScaffoldError
from .answers import Answers
from .launch_format import activated, launch_packages
from .node import Node

TESTS = {
    "ament": "linters, the nodes' logic and a launch test",
    "minimal": "what needs neither ROS nor ament",
    "none": "nothing",
}


def tests_of(asked: str) -> str:
    """Return which tests are written; raises ScaffoldError."""
    if asked not in TESTS:
        raise ScaffoldError(f"there are no tests `{asked}`{did_you_mean(asked, TESTS)}; known: {', '.join(TESTS)}")
    return asked


def linted(answers: Answers) -> bool:
    """Return whether ament's linters are among the tests."""
    return answers.tests == "ament"


def launch_tested(answers: Answers) -> bool:
    """Return whether a test starts the launch file."""
    return answers.tests == "ament" and bool(answers.launch) and bool(answers.nodes)


def launch_test_packages(answers: Answers) -> list[str]:
    """Return what that test needs and the launch file does not."""
    if not launch_tested(answers):
        return []
    return [name for name in ("launch", "launch_testing") if name not in launch_packages(answers)]


def logics_tested(answers: Answers, language: str) -> list[str]:
    """Return the modules without ROS that have tests."""
    return [] if answers.tests == "none" else list(answers.logics_in(language))


def first_words(answers: Answers, node: Node) -> str:
    """Return what shows in the log that the launch file brought a node up."""
    return "Hello 1" if node in activated(answers) else node.kind.says
