"""Files that the commands of ament_cmake, its tests, launch_testing and the like need to exist."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Literal

from ...languages.cmake.evaluated_command import EvaluatedCommand, flags_and_values
from ...languages.cmake.values import Word
from .ament_installs import FLAGS_OF_AUTO

COMPILED = frozenset({
    "ament_add_gtest", "ament_add_gmock", "ament_add_gtest_executable", "ament_add_gmock_executable",
    "ament_add_google_benchmark", "ament_add_ros_isolated_gtest", "ament_add_ros_isolated_gmock",
    "ament_auto_add_gtest",
})  # fmt: skip
"""Commands that hand what is left of their arguments to `add_executable`."""
FLAGS = ("SKIP_LINKING_MAIN_LIBRARIES", "SKIP_TEST", "EXCLUDE_FROM_ALL", "WIN32", "MACOSX_BUNDLE")
ONE = ("RUNNER", "TIMEOUT", "WORKING_DIRECTORY")
MANY = ("APPEND_ENV", "APPEND_LIBRARY_DIRS", "ENV")

STARTED = {"ament_add_pytest_test": 1, "ament_add_ros_isolated_pytest_test": 1, "add_launch_test": 0, "add_ros_test": 0}
"""Commands that stop where the file of a test does not exist, and which argument names it."""
PARAMETERS = frozenset({"generate_parameter_library", "generate_parameter_module"})
ENDS = frozenset({"ament_package", "ament_auto_package", "autoware_ament_auto_package"})
"""Commands that hand .cmake files on to the users of the package, and stop where one does not exist."""
EXTRAS = ("CONFIG_EXTRAS", "CONFIG_EXTRAS_POST")

Need = Literal["source", "test", "parameters", "extras"]


def needed_files(call: EvaluatedCommand) -> Iterator[tuple[Need, Sequence[Word]]]:
    """Yield what a command needs, and for what: none where an argument before it can't be evaluated."""
    if call.name in COMPILED:
        yield "source", flags_and_values(call.words[1:], FLAGS, ONE, MANY)[2]
    at = STARTED.get(call.name)
    if at is not None and all(word.is_known and not word.maybe for word in call.words[: at + 1]):
        yield "test", call.words[at : at + 1]
    if call.name in PARAMETERS and all(word.is_known and not word.maybe for word in call.words[:2]):
        yield "parameters", call.words[1:2]
    if call.name in ENDS:
        _, values, _ = flags_and_values(call.words, FLAGS_OF_AUTO, (), (*EXTRAS, "INSTALL_TO_SHARE"))
        for keyword in EXTRAS:
            yield "extras", values.get(keyword, [])
