"""Paths that commands of CMake name, other than those that install files."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.cmake.evaluated_command import EvaluatedCommand, path_in_package
from ...light_dataclasses import replace
from ...ros.share_layout import FOLDERS

INSTALLERS = ("install", "ament_auto_package", "autoware_ament_auto_package")
ONE_FILE = "generate_parameter_"
"""How commands begin that make code of one file: others in its folder are for run time."""


def without_shown_files(call: EvaluatedCommand) -> EvaluatedCommand:
    """Return a call without the SOURCES of add_custom_target: editors show them, and nothing is done with them."""
    if call.name != "add_custom_target" or "SOURCES" not in call.texts:
        return call
    return replace(call, words=call.words[: call.texts.index("SOURCES")])


def paths_of(call: EvaluatedCommand) -> Iterator[str]:
    """Yield the paths that a call's arguments may be, whatever their keywords."""
    for text in call.texts:
        if (path := path_in_package(text, call.folder)) and ("/" in path or "." in path or path in FOLDERS):
            yield path
