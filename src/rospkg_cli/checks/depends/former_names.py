"""Imports of the package's own modules by an unknown package name, as after a copy or a rename."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from ...languages.python.file import PythonFile
from ...languages.python.imports import Import
from ...light_dataclasses import dataclass
from ...ros.interfaces import KINDS
from ...suggest import slips
from .own_imports import OwnImports


@dataclass(frozen=True, slots=True)
class FormerName:
    """An import, and the module of the package that it is intended for."""

    file: PythonFile
    each: Import
    own: str


def former_names(imports: OwnImports) -> Iterator[FormerName]:
    """Yield the imports by another package name of modules and names that this package has."""
    by_top: dict[str, list[FormerName | None]] = {}
    for file, each in imports.run.certain:
        top, _, within = each.module.partition(".")
        if not each.level and top and within.partition(".")[0] not in KINDS:
            own = own_module(imports, each, within)
            by_top.setdefault(top, []).append(FormerName(file, each, own) if own else None)
    for uses in by_top.values():
        found = [use for use in uses if use is not None]
        if len(found) == len(uses) and all(is_unknown(imports, use.each) for use in found):
            yield from (use for use in found if not imports.changes_path(use.file))


def mistyped_tops(imports: OwnImports, known: Collection[FormerName]) -> Iterator[FormerName]:
    """Yield the imports of modules by a misspelt name of this package: `mmy_pkg` for `my_pkg`.

    Whether the own module has what is imported is another question, asked once the name is right.
    """
    seen = {(former.file.path, former.each.span) for former in known}
    for file, each in imports.run.certain:
        top, dot, within = each.module.partition(".")
        near = slips(top, imports.installed.tops) if top and not each.level else []
        is_new = len(near) == 1 and (file.path, each.span) not in seen
        if is_new and is_unknown(imports, each) and not imports.changes_path(file):
            yield FormerName(file, each, near[0] + dot + within)


def own_module(imports: OwnImports, each: Import, within: str) -> str:
    """Return the one module of the package that has all imported names; "" where there is none."""
    found = [f"{top}.{within}" for top in sorted(imports.installed.tops) if within]
    found = [module for module in found if imports.has_all(each, module)]
    return found[0] if len(found) == 1 else ""


def is_unknown(imports: OwnImports, each: Import) -> bool:
    top = each.module.partition(".")[0]
    is_known = imports.is_found(each) or imports.is_from_pip(top) or is_in_cmake(imports, top)
    return imports.table.knows("module") and not is_known


def is_in_cmake(imports: OwnImports, top: str) -> bool:
    """Return whether a CMake file has the name: it may write such a module for the tests."""
    paths = (path for path in imports.files.paths if path.endswith((".cmake", "CMakeLists.txt")))
    return any(top in imports.files.readable_text(path) for path in paths)
