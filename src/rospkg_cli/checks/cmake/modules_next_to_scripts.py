"""Modules that an installed script imports from its own folder, and that are not installed next to it."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from ...languages.python.imports import Import
from ...light_dataclasses import dataclass
from ...package.install_table import InstalledFile
from ...ros.imports import STANDARD
from ...source import Span
from ..repository.path_starts import ALONE, IN_SOURCE, is_started_by_path_alone
from .uninstalled_python import PythonPackages


@dataclass(frozen=True, slots=True)
class LeftModule:
    source: str
    """The module's file."""
    script: str
    path: str
    span: Span
    """Of the script in the install rule."""
    imported: Span
    """Of the import in the script."""
    installed_as: str = ""
    """Where a rule installs it all the same, without its folder; "" where none does."""
    why_unmet: str = ""
    """Why nothing is known to reach the import."""

    @property
    def needs_folder(self) -> bool:
        """Whether its folder must be installed with it, as it is a package."""
        return bool(self.installed_as) or self.source.endswith("/__init__.py")

    @property
    def sentence(self) -> str:
        where = f"installed as `{self.installed_as}`" if self.installed_as else "not installed"
        fails = f"`{self.script}` imports `{self.source}`, which is {where}: the script ends with ModuleNotFoundError"
        if self.needs_folder:
            return f"{fails}; install it next to the script, with its folder (`install(DIRECTORY …)`){self.why_unmet}"
        return f"{fails}; add it to the `install(PROGRAMS …)`{self.why_unmet}"


def modules_left_behind(packages: PythonPackages) -> Iterator[LeftModule]:
    """Yield each module once; nothing where it is unknown what is installed into lib/<package>."""
    table, cmake = packages.table, packages.package.cmake
    hooks = cmake.named("ament_environment_hooks")
    if not table.knows("executable") or not table.knows("module") or not cmake.is_complete or hooks:
        return
    seen: set[str] = set()
    for row in table.of("executable"):
        file = packages.modules.at(row.source) if row.source.endswith(".py") and not row.maybe else None
        if file is None or "sys.path" in file.source.text:
            continue
        for each in file.imports:
            source = source_of(packages, row, each)
            if source and source not in seen:
                seen.add(source)
                flat = next((other.destination for other in table.rows if other.source == source), "")
                why = packages.unmet.why(file, each, row) or by_path(packages, row.source)
                yield LeftModule(source, row.source, row.path, row.span, each.span, flat, why)


def by_path(packages: PythonPackages, script: str) -> str:
    """Return why a script finds its neighbours: people give it to Python where they lie, or PYTHONPATH has them."""
    from ..repository.python_path_settings import ON_PATH, has_on_python_path  # what findings alone need

    files, name = packages.package.cmake.package_files, packages.package.facts.name
    if is_started_by_path_alone(files, name, script, IN_SOURCE):
        return ALONE
    return ON_PATH if has_on_python_path(files, posixpath.dirname(script)) else ""


def source_of(packages: PythonPackages, row: InstalledFile, each: Import) -> str:
    """Return the file next to a script that an import means and that is not next to the installed script, else ""."""
    name, files = each.module.partition(".")[0], packages.package.cmake.package_files
    if (
        each.level
        or each.is_optional
        or each.is_for_typing
        or not name
        or name in STANDARD
        or name in packages.installed
    ):
        return ""
    here = f"{posixpath.dirname(row.source)}/{name}".lstrip("/")
    there = f"{posixpath.dirname(row.destination)}/{name}"
    found = next((path for path in (f"{here}.py", f"{here}/__init__.py") if files.has_file(path)), "")
    is_next_to_it = any(other.destination.startswith((f"{there}.", f"{there}/")) for other in packages.table.rows)
    is_package = found.endswith("/__init__.py") and "/" not in here
    return "" if is_next_to_it or is_package else found
