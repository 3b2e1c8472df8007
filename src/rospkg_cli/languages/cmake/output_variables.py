"""Commands that set variables of their caller to values that are not evaluated, or only in part."""

from __future__ import annotations

import posixpath

from ...lazy_regex import regex
from ...light_dataclasses import replace
from .call_stack import PYTHON
from .evaluated_command import EvaluatedCommand
from .interpreter import Interpreter
from .values import BINARY, UNKNOWN

NAME = regex(r"[A-Za-z_]\w*")
OUTPUT_KEYWORDS = ("OUTPUT_VARIABLE", "RESULT_VARIABLE", "ERROR_VARIABLE", "RESULTS_VARIABLE")


def set_first_unknown(interpreter: Interpreter, call: EvaluatedCommand) -> None:
    """The first argument names the variable."""
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
