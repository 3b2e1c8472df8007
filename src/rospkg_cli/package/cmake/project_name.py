"""The name of a project, and the command that ends a package: what project() and ament_package() say."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.file import ROOT
from ...languages.cmake.targets import MAKERS
from ...languages.cmake.values import Word
from ...lazy_regex import regex

PACKAGE_ENDS = ("ament_package", "ament_auto_package")
"""The endings of the commands that end a package."""
TESTS = regex(r"(?:ament_)?add_\w*(?:test|gmock)\w*|rosidl_generate_interfaces")
"""Commands that make a test, and what tests use."""


def ends_a_package(calls: Iterable[EvaluatedCommand]) -> bool:
    """Return whether `ament_package` is called, or another command whose name ends with it."""
    return any(call.name.endswith(PACKAGE_ENDS) for call in calls)


def last_project(calls: Sequence[EvaluatedCommand]) -> Word | None:
    """Return the name that ament_package() uses: that of the last project() of CMakeLists.txt before it."""
    ends = [at for at, call in enumerate(calls) if call.name.endswith(PACKAGE_ENDS)]
    projects = [(at, call) for at, call in enumerate(calls) if call.name == "project" and call.path == ROOT]
    named = [(at, call.words[0]) for at, call in projects if call.words]
    before = [word for at, word in named if ends and at < ends[-1]]
    return before[-1] if before else named[0][1] if named else None


def are_only_tests(calls: Sequence[EvaluatedCommand]) -> bool:
    """Return whether all that is built, installed or exported is for tests; linters alone are no tests."""
    done = [call for call in calls if call.name == "install" or call.name in MAKERS or "export" in call.name]
    made = [call for call in calls if call.testing and (call.name in MAKERS or TESTS.fullmatch(call.name))]
    return bool(made) and all(call.testing for call in done)
