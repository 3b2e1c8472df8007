"""The packages that launch files in Python import, and which Python files launch files import from each other."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ...files import PackageFiles
from ...package.file_role import role_of
from ...package.launch.launch_file import LaunchFile
from ...package.python.own_modules import own_modules
from ...ros.imports import may_serve
from ..launch.launched_programs import is_program
from ..launch.package_reference import PackageReference
from .declared_dependencies import DeclaredDependencies
from .import_provider import import_providers


def is_imported(file: LaunchFile, launch_files: Iterable[LaunchFile]) -> bool:
    """Return whether another launch file imports one, as a helper."""
    stem = stem_of(file.path)
    others = (each for other in launch_files if other is not file for each in other.imports)
    return any(stem in (each.module.rpartition(".")[2], *each.names) for each in others)


def import_uses(
    file: LaunchFile, launch_files: Iterable[LaunchFile], declared: DeclaredDependencies, files: PackageFiles
) -> Iterator[PackageReference]:
    """Yield what a Python launch file imports, as the declared provider or else the one to declare.

    Files that are modules of the package as well are left out: DEP101 reports their imports.
    """
    is_launched = file.has_entry_point and not is_program(file)
    if role_of(file.path) == "run" or (not is_launched and not is_imported(file, launch_files)):
        return
    own = own_modules(files)
    for each in file.imports:
        if each.level or each.is_optional or each.is_for_typing or own.has(each.module, file.path):
            continue
        names = import_providers(declared, each)
        known = next((name for name in names if name in declared.names), None)
        if known or not any(may_serve(name, each.module) for name in declared.names):
            for name in (known,) if known else names[:1]:
                does = "imports" if name == each.module.partition(".")[0] else f"imports `{each.module}` of"
                yield PackageReference(name, file.path, each.span, does, fails="import")


def stem_of(path: str) -> str:
    return path.rpartition("/")[2].removesuffix(".py")
