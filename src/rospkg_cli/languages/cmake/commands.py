"""What each command of CMake does to the state of the run; what is not here only gets recorded."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Callable, Mapping

from .call_stack import PYTHON, LeaveError
from .evaluated_command import EvaluatedCommand
from .file import ROOT
from .file_command import run_file
from .interpreter import Interpreter
from .string_commands import run_get_filename_component, run_string
from .targets import MAKERS
from .values import BINARY, SOURCE, UNKNOWN
from .variable_commands import (
    run_list,
    run_math,
    run_option,
    run_parse_arguments,
    run_separate_arguments,
    run_set,
    run_unset,
)
from .variable_scope import VariableScope

NAME = re.compile(r"[A-Za-z_]\w*")

OUTPUT_KEYWORDS = ("OUTPUT_VARIABLE", "RESULT_VARIABLE", "ERROR_VARIABLE", "RESULTS_VARIABLE")
FIRST_IS_OUTPUT = ("find_program", "find_library", "find_path", "find_file", "get_target_property", "get_property",
                   "get_directory_property", "get_source_file_property", "get_test_property", "try_compile",
                   "try_run", "cmake_host_system_information", "aux_source_directory")  # fmt: skip


def run_project(machine: Interpreter, call: EvaluatedCommand) -> None:
    for name in call.texts[:1]:
        top = machine.frame.folder == ""
        here = posixpath.join(SOURCE, machine.frame.folder).rstrip("/")
        there = posixpath.join(BINARY, machine.frame.folder).rstrip("/")
        for prefix in ("PROJECT", name):
            machine.set_text(f"{prefix}_SOURCE_DIR", here)
            machine.set_text(f"{prefix}_BINARY_DIR", there)
        machine.set_text("PROJECT_NAME", name)
        if top:
            machine.set_text("CMAKE_PROJECT_NAME", name)


def run_find_package(machine: Interpreter, call: EvaluatedCommand) -> None:
    """What is required was found, or the configuration stopped."""
    for name in call.texts[:1]:
        if "REQUIRED" in call.texts and not call.maybe:
            machine.set_text(f"{name}_FOUND", "1")
        machine.touched.update({f"{name}_FOUND", f"{name.upper()}_FOUND"})


def run_include(machine: Interpreter, call: EvaluatedCommand) -> None:
    """Run a file of the package; a module of CMake's own (`include(CTest)`) sets nothing that matters here."""
    if not call.words or NAME.fullmatch(call.texts[0]):
        return
    path = machine.path(call.texts[0])
    if path is not None and machine.files.holds(path):
        machine.file(path)
    else:
        machine.clouded = True


def run_add_subdirectory(machine: Interpreter, call: EvaluatedCommand) -> None:
    """Run a folder's CMakeLists.txt in a scope of its own."""
    folder = machine.path(call.texts[0]) if call.texts else None
    if folder is None or not machine.files.holds(posixpath.join(folder, ROOT)):
        machine.clouded = True
        return
    outer = machine.scope
    machine.scope = VariableScope(outer)
    try:
        machine.file(posixpath.join(folder, ROOT), folder)
    finally:
        machine.scope = outer


def run_target(machine: Interpreter, call: EvaluatedCommand) -> None:
    for text in call.texts[:1]:
        if UNKNOWN not in text and not call.maybe:
            machine.targets[text] = machine.targets.get(text, True) and call.testing


def run_message(machine: Interpreter, call: EvaluatedCommand) -> None:
    if call.texts[:1] == ("FATAL_ERROR",):
        raise LeaveError("fatal")


def leave(how: str) -> Callable[[Interpreter, EvaluatedCommand], None]:
    def run(machine: Interpreter, call: EvaluatedCommand) -> None:
        raise LeaveError(how)

    return run


def unseen(machine: Interpreter, call: EvaluatedCommand) -> None:
    """What FetchContent brings is read as part of the package."""
    machine.clouded = True


def first_is_output(machine: Interpreter, call: EvaluatedCommand) -> None:
    for name in call.texts[:1]:
        machine.set(name, machine.hole())


def run_python_install_dir(machine: Interpreter, call: EvaluatedCommand) -> None:
    """`ament_get_python_install_dir(name)`"""
    for name in call.texts[:1]:
        machine.set_text(name, PYTHON)


def named_outputs(machine: Interpreter, call: EvaluatedCommand) -> None:
    """What execute_process and the like write is unknown."""
    for keyword, name in zip(call.texts, call.texts[1:], strict=False):
        if keyword in OUTPUT_KEYWORDS:
            machine.set(name, machine.hole())


def foreign(machine: Interpreter, call: EvaluatedCommand) -> None:
    """A command of another package may set any variable whose name it is given."""
    for text in call.texts:
        if NAME.fullmatch(text):
            machine.touched.add(text)
            if machine.scope.get(text) is not None:
                machine.set(text, machine.hole())


def nothing(machine: Interpreter, call: EvaluatedCommand) -> None:
    """Only recorded."""


HARMLESS = frozenset(
    """
    add_compile_definitions add_compile_options add_custom_command add_custom_target add_definitions
    add_dependencies add_test cmake_minimum_required cmake_policy configure_file enable_language enable_testing
    export include_directories include_guard install link_directories link_libraries mark_as_advanced
    set_directory_properties set_property set_source_files_properties set_target_properties set_tests_properties
    source_group target_compile_definitions target_compile_features target_compile_options
    target_include_directories target_link_directories target_link_libraries target_link_options
    target_precompile_headers target_sources ament_package ament_auto_package ament_target_dependencies
    ament_export_dependencies ament_export_targets ament_export_libraries ament_export_include_directories
    ament_export_interfaces ament_python_install_package ament_auto_add_executable ament_auto_add_library
    ament_auto_find_build_dependencies ament_environment_hooks ament_lint_auto_find_test_dependencies
    ament_add_gtest ament_add_gmock ament_add_pytest_test ament_auto_add_gtest rclcpp_components_register_node
    rclcpp_components_register_nodes rosidl_generate_interfaces pluginlib_export_plugin_description_file
    generate_parameter_library generate_parameter_module rosidl_target_interfaces
""".split()
)
"""Commands that set no variable of the caller."""

COMMANDS: Mapping[str, Callable[[Interpreter, EvaluatedCommand], None]] = {
    **dict.fromkeys(HARMLESS, nothing),
    **dict.fromkeys(FIRST_IS_OUTPUT, first_is_output),
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
    "execute_process": named_outputs,
    "ament_get_python_install_dir": run_python_install_dir,
    "fetchcontent_makeavailable": unseen,
    "fetchcontent_populate": unseen,
    "project": run_project,
    "find_package": run_find_package,
    "include": run_include,
    "add_subdirectory": run_add_subdirectory,
    **dict.fromkeys(MAKERS.keys() - {"rclcpp_components_register_node"}, run_target),
    "message": run_message,
    "return": leave("return"),
    "break": leave("break"),
    "continue": leave("continue"),
}
