"""The effect of each command of CMake on the state; other commands are only recorded."""

from __future__ import annotations

import posixpath
from collections.abc import Callable, Mapping

from ...lazy_regex import regex
from ...light_dataclasses import replace
from .call_stack import FOUND, PYTHON, LeaveError
from .evaluated_command import EvaluatedCommand
from .file import ROOT
from .file_command import run_file
from .interpreter import Interpreter
from .list_command import run_list
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
from .variable_scope import VariableScope

NAME = regex(r"[A-Za-z_]\w*")
OF_CMAKE = regex(r"(?:Add|Android|Bundle|Check|CMake|CPack|CTest|External|Find|Fetch|Test|Use)\w*|GNUInstallDirs|"
                 r"GoogleTest|FeatureSummary|GenerateExportHeader|ProcessorCount")  # fmt: skip
"""Modules of CMake, and what is called like one."""

OUTPUT_KEYWORDS = ("OUTPUT_VARIABLE", "RESULT_VARIABLE", "ERROR_VARIABLE", "RESULTS_VARIABLE")
FIRST_IS_OUTPUT = ("find_program", "find_library", "find_path", "find_file", "get_target_property", "get_property",
                   "get_directory_property", "get_source_file_property", "get_test_property", "try_compile",
                   "try_run", "cmake_host_system_information", "aux_source_directory")  # fmt: skip


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


def run_include(interpreter: Interpreter, call: EvaluatedCommand) -> None:
    """Run a file of the package; CMake's own modules (`include(CTest)`) set no variable that matters here."""
    if not call.words:
        return
    is_module = NAME.fullmatch(call.texts[0]) is not None
    path = own_module(interpreter, call.texts[0]) if is_module else interpreter.path(call.texts[0])
    if path is not None and interpreter.files.has_file(path):
        interpreter.file(path)
    elif not is_module or is_elsewhere(interpreter, call.texts[0]):
        interpreter.reads_unknown_files = interpreter.includes_unknown_files = True


def own_module(interpreter: Interpreter, name: str) -> str | None:
    """Return the package's own module of a name, which CMake finds through CMAKE_MODULE_PATH."""
    folders = interpreter.value_if_set("CMAKE_MODULE_PATH") or ()
    paths = (interpreter.path(f"{folder.text}/{name}.cmake") for folder in folders)
    return next((path for path in paths if path is not None and interpreter.files.has_file(path)), None)


def is_elsewhere(interpreter: Interpreter, name: str) -> bool:
    """Return whether a module may be one that is not read: of the package, or of a folder above it."""
    if any(place.endswith(f"/{name}.cmake") for place in interpreter.places):
        return True
    texts = [folder.text for folder in interpreter.value_if_set("CMAKE_MODULE_PATH") or ()]
    above = [text for text in texts if text.startswith((SOURCE, "..")) and UNKNOWN not in text]
    return OF_CMAKE.fullmatch(name) is None and any(interpreter.path(text) is None for text in above)


def run_add_subdirectory(interpreter: Interpreter, call: EvaluatedCommand) -> None:
    """Run a folder's CMakeLists.txt in a new scope."""
    folder = interpreter.path(call.texts[0]) if call.texts else None
    if folder is None or not interpreter.files.has_file(posixpath.join(folder, ROOT)):
        interpreter.reads_unknown_files = True
        interpreter.includes_unknown_files |= folder is None
        return
    outer = interpreter.scope
    interpreter.scope = VariableScope(outer)
    try:
        interpreter.file(posixpath.join(folder, ROOT), folder)
    finally:
        interpreter.scope = outer


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


def set_first_unknown(interpreter: Interpreter, call: EvaluatedCommand) -> None:
    for name in call.texts[:1]:
        interpreter.set(name, interpreter.unknown())


def run_python_install_dir(interpreter: Interpreter, call: EvaluatedCommand) -> None:
    """`ament_get_python_install_dir(name)`"""
    for name in call.texts[:1]:
        interpreter.set_text(name, PYTHON)


def run_qt_wrap(interpreter: Interpreter, call: EvaluatedCommand) -> None:
    """`qt5_wrap_cpp(sources a.hpp)` appends a generated file for each that is given to the variable."""
    for name in call.texts[:1]:
        made = [replace(word, text=generated_name(word.text)) for word in call.words[1:]]
        interpreter.set(name, (*(interpreter.value_if_set(name) or ()), *made))


def generated_name(text: str) -> str:
    return UNKNOWN if UNKNOWN in text else posixpath.join(BINARY, f"wrapped_{posixpath.basename(text)}.cpp")


def set_outputs_unknown(interpreter: Interpreter, call: EvaluatedCommand) -> None:
    """The output variables of execute_process and similar commands are unknown."""
    for keyword, name in zip(call.texts, call.texts[1:], strict=False):
        if keyword in OUTPUT_KEYWORDS:
            interpreter.set(name, interpreter.unknown())


def run_unknown_command(interpreter: Interpreter, call: EvaluatedCommand) -> None:
    """A command of another package may set any variable whose name it is given."""
    for text in call.texts:
        if NAME.fullmatch(text):
            interpreter.possibly_assigned.add(text)
            if interpreter.scope.get(text) is not None:
                interpreter.set(text, interpreter.unknown())


def has_no_effect(interpreter: Interpreter, call: EvaluatedCommand) -> None:
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

QT_WRAPPERS = tuple(f"qt{version}_{what}" for version in ("4", "5", "6", "") for what in ("wrap_cpp", "wrap_ui"))

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
