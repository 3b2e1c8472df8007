"""Commands that neither CMake nor the usual packages define: macros of other packages, which may install anything."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...lazy_regex import regex
from ...ros.read_table import words
from .cmake_project import CMake

FAMILIAR = regex(
    r"_?(?:ament|rosidl|rclcpp|pluginlib|catkin|xacro|generate_parameter|protobuf|pybind11|nanobind|python3?|swig|cuda"
    r"|qt\d?|pkg|cmake|fetchcontent|externalproject|gtest|find|check|target|get|set|enable|print|write_basic"
    r"|configure_package_config|generate_export|nav2_add|call_for_each)_\w+"
    r"|add_\w*test|autoware_ament_\w+|cpmaddpackage|extract_package_metadata|test_big_endian|processorcount"
    r"|doxygen_add_docs|feature_summary|exec_program|make_directory|include_external_msproject"
)
"""Commands of CMake's modules, ament and well-known libraries, which put nothing into the share directory, or whose
files are read by other means; and those whose verb is not one of installing."""


OF_OPTIONS = regex(r"(?:nav2|autoware|moveit)_package|append_\w+|export_windows_symbols|\w+_(?:flags|options|warnings)")
"""Commands that take no words and only set options for the compiler, or find packages."""


def may_make_targets(cmake: CMake) -> bool:
    """Return whether a macro of another package is called that may make targets, of files that it finds itself."""
    return any(foreign_commands(cmake)) or any(commands_without_words(cmake))


def commands_without_words(cmake: CMake) -> Iterator[EvaluatedCommand]:
    """Yield the calls of macros of other packages that are given nothing, and may find all by themselves."""
    for call in unfamiliar_commands(cmake):
        if not call.words and not OF_OPTIONS.fullmatch(call.name):
            yield call


def foreign_commands(cmake: CMake) -> Iterator[EvaluatedCommand]:
    """Yield the first call of each macro of another package that is given something; those for tests are left out."""
    seen = set()
    for call in unfamiliar_commands(cmake):
        if call.words and call.name not in seen:
            seen.add(call.name)
            yield call


def unfamiliar_commands(cmake: CMake) -> Iterator[EvaluatedCommand]:
    """Yield the calls of macros of other packages; those for tests are left out."""
    for call in cmake.calls:
        is_known = call.name in everybodys() or call.name in cmake.functions
        if not is_known and not call.testing and not FAMILIAR.fullmatch(call.name):
            yield call


def names_for_macros(cmake: CMake) -> frozenset[str]:
    """Return all that macros of other packages are given, the parts of a list each: what they do with it is unknown."""
    return frozenset(part for call in unfamiliar_commands(cmake) for text in call.texts for part in text.split(";"))


@lru_cache(maxsize=1)
def everybodys() -> frozenset[str]:
    """Return the commands of CMake and of ament."""
    from ...languages.cmake.commands import COMMANDS  # two dozen modules that other packages need not import

    return frozenset({*COMMANDS, *words("cmake_commands.txt")})
