"""The install table of a package that colcon builds with its setup.py."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator

from ...languages.python.evaluate.sandbox_filesystem import OutsideError
from ...lazy_regex import regex
from ...source import Span
from ..install_table import PYTHON, InstalledFile, InstallKind, InstallTable, UnknownPart
from ..package_facts import NOWHERE
from .setup_py import SetupPy

BASE = regex(r"\$(?:base|\{base\}|prefix)/*(?P<rest>.*)")
GENERATED: tuple[InstallKind, ...] = ("share", "module")

ARGUMENTS: dict[str, tuple[InstallKind, ...]] = {
    "data_files": ("share", "executable"),
    "entry_points": ("executable",),
    "scripts": ("executable",),
    "packages": ("module",),
    "py_modules": ("module",),
    "package_dir": ("module",),
    "package_data": ("module",),
}
"""The arguments of setup(), and which part of the table each of them makes."""

MARKERS = "share/ament_index/resource_index/packages"


def python_table(setup: SetupPy, name: str) -> InstallTable:
    """Return what colcon installs for a package of that name."""
    unknown = [
        UnknownPart(what, why.why, setup.path, why.span)
        for argument, whats in ARGUMENTS.items()
        if (why := setup.unknown.get(argument)) is not None
        for what in whats
    ]
    folder = script_folder(setup)
    if folder is None:
        unknown.append(UnknownPart("executable", "the scripts' folder in setup.cfg is unknown", "setup.cfg", NOWHERE))
    if setup.may_write_files:
        writes = "setup.py calls what may write files"
        unknown += [UnknownPart(what, writes, setup.path, setup.span) for what in GENERATED]
    if setup.value("include_package_data") and setup.folder.kind("MANIFEST.in"):
        unknown.append(
            UnknownPart("other", "files that MANIFEST.in adds to modules are not followed", "MANIFEST.in", NOWHERE)
        )
    rows = [
        *data_rows(setup),
        *implied_rows(setup, name),
        *script_rows(setup, folder or "bin"),
        *module_rows(setup, name),
    ]
    return InstallTable(tuple(dict.fromkeys(rows)), tuple(unknown))


def script_folder(setup: SetupPy) -> str | None:
    """Return the folder of executables below the prefix; None where it is unknown."""
    option = setup.cfg.get("install", "install_scripts") if setup.cfg else None
    if option is None:
        return None if setup.cfg_broken and setup.cfg is None else "bin"
    match = BASE.fullmatch(option.value.text)
    return posixpath.normpath(match["rest"] or ".") if match and "$" not in match["rest"] else None


def data_rows(setup: SetupPy) -> Iterator[InstalledFile]:
    for file in setup.data_files:
        if file.source is None or not file.destination or setup.kind(file.source) != "file":
            continue
        what: InstallKind = "share" if file.destination.startswith("share/") else "other"
        if re.fullmatch(r"lib/[^/]+/[^/]+|bin/[^/]+", file.destination):
            what = "executable"
        yield InstalledFile(what, file.destination, file.source, "", file.setup_text.path, file.setup_text.shown)


def implied_rows(setup: SetupPy, name: str) -> Iterator[InstalledFile]:
    """What colcon installs, with a warning, where data_files does not."""
    wanted = {f"{MARKERS}/{name}": "", f"share/{name}/package.xml": "package.xml"}
    installed = {file.destination for file in setup.data_files}
    for destination, source in wanted.items():
        if destination not in installed and setup.knows("data_files"):
            yield InstalledFile("share", destination, source, "", setup.path, setup.span)


def script_rows(setup: SetupPy, folder: str) -> Iterator[InstalledFile]:
    for entry in setup.entry_points:
        if entry.is_script and entry.name and not entry.fault:
            destination = posixpath.join(folder, entry.name)
            yield InstalledFile(
                "executable", destination, "", f"{entry.module}:{entry.attribute}", entry.path, entry.span
            )
    for script in setup.scripts:
        destination = posixpath.join(folder, posixpath.basename(script.text))
        yield InstalledFile("executable", destination, script.text, "", script.path, script.shown)


def module_rows(setup: SetupPy, package: str) -> Iterator[InstalledFile]:
    argument = setup.argument("packages")
    at = argument.span if argument else setup.span
    for module, path in setup.modules.items():
        name = "__init__.py" if path.endswith("/__init__.py") else posixpath.basename(path)
        folder = module.replace(".", "/") if name == "__init__.py" else posixpath.dirname(module.replace(".", "/"))
        yield InstalledFile("module", posixpath.join(PYTHON, folder, name), path, "", setup.path, at)
    for name in setup.generated:
        yield InstalledFile("module", posixpath.join(PYTHON, package, f"{name}.py"), "", "", setup.path, at)
    for key, patterns in setup.package_data.items():
        for each in [item.text for item in setup.packages] if key in ("", "*") else [key]:
            yield from package_data(setup, each, patterns, at)


def package_data(setup: SetupPy, package: str, patterns: tuple[str, ...], at: Span) -> Iterator[InstalledFile]:
    folder = setup.folder_of(package)
    for pattern in patterns:
        try:
            found = setup.folder.glob(posixpath.join(folder, pattern), recursive=True)
        except OutsideError:
            continue
        for path in found:
            if setup.kind(path) == "file" and not path.endswith(".py"):
                inside = posixpath.relpath(path, folder or ".")
                destination = posixpath.join(PYTHON, package.replace(".", "/"), inside)
                yield InstalledFile("module", destination, path, "", setup.path, at)
