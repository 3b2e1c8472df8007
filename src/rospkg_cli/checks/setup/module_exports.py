"""Whether a module has a name: by its own text, and by star imports of other modules of the package."""

from __future__ import annotations

from ...languages.python.imports import Import
from ...package.python_modules import PythonModules
from ...package.setup.setup_py import SetupPy

MAX_DEPTH = 10


def offers(modules: PythonModules, setup: SetupPy, path: str, name: str, depth: int = 0) -> bool:
    """Return whether a file defines or imports a name at its top level, or may do so."""
    file = modules.at(path)
    if file is None or depth > MAX_DEPTH or file.has_dynamic_names or name in file.definitions:
        return True
    for star in file.star_imports:
        inner = setup.file_of(absolute(star, path, setup))
        if inner is None or offers(modules, setup, inner, name, depth + 1):
            return True
    return False


def absolute(each: Import, path: str, setup: SetupPy) -> str:
    """Return the dotted name of what a file imports."""
    if not each.level:
        return each.module
    base = setup.package_dir.get("", "")
    inside = path[len(base) + 1 :] if base and path.startswith(f"{base}/") else path
    package = inside.split("/")[: -each.level]
    return ".".join([*package, *([each.module] if each.module else [])])
