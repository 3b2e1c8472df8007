"""The effect of each command of CMake on the state; other commands are only recorded."""

from __future__ import annotations

import posixpath
from collections.abc import Callable, Mapping

from .call_stack import FOUND, LeaveError
from .command_names import FIRST_IS_OUTPUT, HARMLESS, QT_WRAPPERS
from .evaluated_command import EvaluatedCommand
from .file_command import run_file
from .included_files import run_add_subdirectory, run_include
from .interpreter import Interpreter
from .list_command import run_list
from .output_variables import run_python_install_dir, run_qt_wrap, set_first_unknown, set_outputs_unknown
from .string_commands import run_get_filename_component, run_string
from .targets import MAKERS
from .values import BINARY, SOURCE, UNKNOWN
from .variable_commands import (
    run_math,
    run_option,
    run_parse_arguments,
    run_separate_arguments,
    run_set,
    run_unset,
)


def run_project(interpreter: Interpreter, call: EvaluatedCommand) -> None:
    for given in call.texts[:1]:
        name = interpreter.own_name if UNKNOWN in given and interpreter.own_name else given
        top = interpreter.frame.folder == ""
        here = posixpath.join(SOURCE, interpreter.frame.folder).rstrip("/")
        there = posixpath.join(BINARY, interpreter.frame.folder).rstrip("/")
        for prefix in ("PROJECT", name):
            interpreter.set_text(f"{prefix}_SOURCE_DIR", here)
            interpreter.set_text(f"{prefix}_BINARY_DIR", there)
        interpreter.set_text("PROJECT_NAME", name)
        if top:
            interpreter.set_text("CMAKE_PROJECT_NAME", name)


def run_find_package(interpreter: Interpreter, call: EvaluatedCommand) -> None:
    """A required package was found, or the configuration stopped."""
    for name in call.texts[:1]:
        if "REQUIRED" in call.texts and not call.maybe:
            interpreter.set_text(f"{name}_FOUND", "1")
        elif name in FOUND and not call.maybe:
            interpreter.set_text(f"{name}_FOUND", FOUND[name])
        interpreter.possibly_assigned.update({f"{name}_FOUND", f"{name.upper()}_FOUND"})


def run_target(interpreter: Interpreter, call: EvaluatedCommand) -> None:
    for text in call.texts[:1]:
        if UNKNOWN not in text and not call.maybe:
            interpreter.targets[text] = interpreter.targets.get(text, True) and call.testing


def run_message(interpreter: Interpreter, call: EvaluatedCommand) -> None:
    if call.texts[:1] == ("FATAL_ERROR",):
        raise LeaveError("fatal")


def leave_by(how: str) -> Callable[[Interpreter, EvaluatedCommand], None]:
    def run(interpreter: Interpreter, call: EvaluatedCommand) -> None:
        raise LeaveError(how)

    return run


def has_unknown_effects(interpreter: Interpreter, call: EvaluatedCommand) -> None:
    """FetchContent adds unknown CMake files to the run, each in a scope of its own."""
    interpreter.reads_unknown_files = True


def has_no_effect(interpreter: Interpreter, call: EvaluatedCommand) -> None:
    """Only recorded."""


COMMANDS: Mapping[str, Callable[[Interpreter, EvaluatedCommand], None]] = {
    **dict.fromkeys(HARMLESS, has_no_effect),
    **dict.fromkeys(FIRST_IS_OUTPUT, set_first_unknown),
    "set": run_set,
    "unset": run_unset,
    "option": run_option,
    "list": run_list,
    "math": run_math,
    "separate_arguments": run_separate_arguments,
    "cmake_parse_arguments": run_parse_arguments,
    "string": run_string,
    "get_filename_component": run_get_filename_component,
    "file": run_file,
    **dict.fromkeys(QT_WRAPPERS, run_qt_wrap),
    "execute_process": set_outputs_unknown,
    "ament_get_python_install_dir": run_python_install_dir,
    "fetchcontent_makeavailable": has_unknown_effects,
    "fetchcontent_populate": has_unknown_effects,
    "project": run_project,
    "find_package": run_find_package,
    "include": run_include,
    "add_subdirectory": run_add_subdirectory,
    **dict.fromkeys(MAKERS.keys() - {"rclcpp_components_register_node"}, run_target),
    "message": run_message,
    "return": leave_by("return"),
    "break": leave_by("break"),
    "continue": leave_by("continue"),
}
