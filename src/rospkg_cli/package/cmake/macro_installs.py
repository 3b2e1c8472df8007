"""What macros of ament, rosidl and others install, in addition to the calls of `install`."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from ...languages.cmake.evaluated_command import EvaluatedCommand, flags_and_values, path_in_package
from ...languages.cmake.values import Word
from ..install_table import PYTHON
from .cmake_project import CMake
from .install_destinations import below_prefix

MacroInstall = tuple[str, str, Word, EvaluatedCommand]
"""Destination, the file that it is a copy of ("" for none), the argument that says so, and its call."""

PACKAGE = ("ament_package", "ament_auto_package", "autoware_ament_auto_package")


def installed_by_macros(cmake: CMake, name: str) -> Iterator[MacroInstall]:
    """Yield what is installed for the package called `name`, as far as it is known."""
    yield from components(cmake, name)
    yield from interfaces(cmake, name)
    for call in cmake.calls:
        if call.name in ("generate_parameter_library", "generate_parameter_module") and call.words:
            yield from parameters(call, name)
        elif call.name == "ament_generate_version_header":
            yield from version_header(call, cmake.project_name)
        elif call.name in (*PACKAGE, "list", "set"):
            yield from config_extras(call, cmake, name)


def components(cmake: CMake, name: str) -> Iterator[MacroInstall]:
    for component in cmake.components:
        if component.executable is not None and component.executable.is_known:
            yield f"lib/{name}/{component.executable.text}", "", component.executable, component.call


def interfaces(cmake: CMake, name: str) -> Iterator[MacroInstall]:
    """The interface files themselves; their .idl forms and the code made of them are left to rosidl."""
    for each in cmake.interface_targets:
        for word in each.files:
            path = word.text.rpartition(":")[2] if not each.skip_install and word.is_known else ""
            if path:
                folder, file = posixpath.split(path)
                place = f"share/{name}/{posixpath.basename(folder)}/{file}"
                yield posixpath.normpath(place), posixpath.join(each.call.folder, path), word, each.call


def parameters(call: EvaluatedCommand, name: str) -> Iterator[MacroInstall]:
    """The code that generate_parameter_library makes, and the header that it is validated with."""
    first = call.words[0]
    if call.name == "generate_parameter_module":
        yield f"{PYTHON}/{name}/{first.text}.py", "", first, call
        return
    yield f"include/{name}/{first.text}.hpp", "", first, call
    for word in call.words[2:3]:
        yield (
            f"include/{name}/{posixpath.basename(word.text)}",
            path_in_package(word.text, call.folder) or "",
            word,
            call,
        )


def version_header(call: EvaluatedCommand, project: str) -> Iterator[MacroInstall]:
    """`ament_generate_version_header(target HEADER_PATH my_pkg/version.h INSTALL_PATH include/my_pkg)`"""
    flags, values, _ = flags_and_values(call.words, ("SKIP_INSTALL",), ("HEADER_PATH", "INSTALL_PATH"), ())
    header, place = (
        values[keyword][0].text if values.get(keyword) else fallback
        for keyword, fallback in (("HEADER_PATH", f"{project}/version.h"), ("INSTALL_PATH", f"include/{project}"))
    )
    folder = below_prefix(posixpath.join(place, header))
    if folder is not None and call.words and "SKIP_INSTALL" not in flags:
        yield folder, "", call.words[0], call


def config_extras(call: EvaluatedCommand, cmake: CMake, name: str) -> Iterator[MacroInstall]:
    """The files of CMake that `ament_package(CONFIG_EXTRAS …)` gives to those who find the package."""
    for word in handed_on(call, cmake):
        file = posixpath.basename(word.text)
        if word.is_known and file.endswith((".cmake", ".cmake.in")):
            source = path_in_package(word.text, call.folder) if file.endswith(".cmake") else None
            yield f"share/{name}/cmake/{file.removesuffix('.in')}", source or "", word, call


def handed_on(call: EvaluatedCommand, cmake: CMake) -> list[Word]:
    """Return the words of a call that name files of CMake which run in every package that finds this one."""
    if call.name in PACKAGE:
        _, values, _ = flags_and_values(call.words, (), ("CONFIG_EXTRAS_POST",), ("CONFIG_EXTRAS", "INSTALL_TO_SHARE"))
        words = [*values.get("CONFIG_EXTRAS", []), *values.get("CONFIG_EXTRAS_POST", [])]
    else:
        variables = [f"{cmake.project_name}_CONFIG_EXTRAS", f"{cmake.project_name}_CONFIG_EXTRAS_POST"]
        at = 1 if call.name == "list" else 0
        words = list(call.words[at + 1 :]) if call.texts[at : at + 1] and call.texts[at] in variables else []
    return words
