"""`include` and `add_subdirectory`: the evaluation goes on in another file of the package."""

from __future__ import annotations

import posixpath

from ...lazy_regex import regex
from .evaluated_command import EvaluatedCommand
from .file import ROOT
from .interpreter import Interpreter
from .values import SOURCE, UNKNOWN
from .variable_scope import VariableScope

NAME = regex(r"[A-Za-z_]\w*")
OF_CMAKE = regex(r"(?:Add|Android|Bundle|Check|CMake|CPack|CTest|External|Find|Fetch|Test|Use)\w*|GNUInstallDirs|"
                 r"GoogleTest|FeatureSummary|GenerateExportHeader|ProcessorCount")  # fmt: skip
"""Modules of CMake, and what is called like one."""


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
