"""Scripts that `ament_python_install_package(… SCRIPTS_DESTINATION lib/package)` makes of a setup.cfg."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from ...files import PackageFiles
from ...languages.cmake.evaluated_command import EvaluatedCommand, flags_and_values, path_in_package
from ...languages.cmake.values import Word
from ...light_dataclasses import replace
from ...source import Span
from ...unreadable import UnreadableError
from ..install_table import InstalledFile, UnknownPart
from ..setup.entry_point import EntryPoint, parse_entry_point
from ..setup.parse_setup_cfg import parse_setup_cfg
from ..setup.setup_cfg_arguments import items_of
from .install_destinations import below_prefix
from .install_keywords import PACKAGE_KEYWORDS

REFUSED = frozenset({"no-equals", "joined", "unreadable"})
"""What no version of setuptools reads as an entry point; a file's name, or a module alone, is one in form."""


def python_scripts(call: EvaluatedCommand, files: PackageFiles) -> Iterator[InstalledFile | UnknownPart]:
    """Yield the executables of one call: the `console_scripts`, and what `[options]` lists under `scripts`.

    The setup.cfg is that of SETUP_CFG, or the one next to the call's CMakeLists.txt; without SCRIPTS_DESTINATION
    there are none.
    """
    _, values, _ = flags_and_values(call.words, ("SKIP_COMPILE",), PACKAGE_KEYWORDS, ())
    for place in values.get("SCRIPTS_DESTINATION", [])[:1]:
        setup_cfg = next(iter(values.get("SETUP_CFG", [])), None)
        path = path_in_package(setup_cfg.text if setup_cfg else "setup.cfg", call.folder)
        folder = below_prefix(place.text)
        if path is None or folder is None or (setup_cfg and not files.exists(path)):
            yield unknown(
                place if folder is None else setup_cfg or place, "the scripts of setup.cfg can't be determined"
            )
        elif files.exists(path):
            try:
                for script in scripts_of(path, folder, files):
                    yield replace(script, maybe=call.maybe, testing=call.testing)
            except UnreadableError:
                yield unknown(place, f"`{path}` can't be read")


def refused_entries(call: EvaluatedCommand, files: PackageFiles) -> Iterator[EntryPoint]:
    """Yield the entry points of a call's setup.cfg that setuptools refuses while CMake writes the package's metadata.

    That happens without SCRIPTS_DESTINATION too (ament_cmake_python: `setup.py egg_info` with a link to setup.cfg).
    """
    _, values, _ = flags_and_values(call.words, ("SKIP_COMPILE",), PACKAGE_KEYWORDS, ())
    named = next(iter(values.get("SETUP_CFG", [])), None)
    path = path_in_package(named.text if named else "setup.cfg", call.folder)
    if path is None or not files.exists(path):
        return
    try:
        cfg = parse_setup_cfg(files.source(path))
    except UnreadableError:
        return
    for option in cfg.options("options.entry_points"):
        entries = (parse_entry_point(option.key, line) for line in option.value.lines())
        yield from (entry for entry in entries if entry.fault in REFUSED)


def scripts_of(path: str, folder: str, files: PackageFiles) -> Iterator[InstalledFile]:
    """Raises UnreadableError."""
    cfg = parse_setup_cfg(files.source(path))
    for option in cfg.options("options.entry_points"):
        for line in option.value.lines():
            entry = parse_entry_point(option.key, line)
            if entry.is_script and entry.name and not entry.fault:
                yield row(folder, entry.name, path, entry.span, entry=f"{entry.module}:{entry.attribute}")
    scripts = cfg.get("options", "scripts")
    for script_text in items_of(scripts.value) if scripts is not None else ():
        source = posixpath.normpath(posixpath.join(posixpath.dirname(path), script_text.text))
        yield row(folder, posixpath.basename(script_text.text), path, script_text.shown, source=source)


def row(folder: str, name: str, path: str, span: Span, source: str = "", entry: str = "") -> InstalledFile:
    return InstalledFile("executable", posixpath.normpath(posixpath.join(folder, name)), source, entry, path, span)


def unknown(word: Word, why: str) -> UnknownPart:
    return UnknownPart("executable", why, word.path, word.span)
