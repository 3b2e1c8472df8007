"""Functions that nothing calls, in Python files next to launch files that nothing imports (LCH003, LCH004)."""

from __future__ import annotations

import posixpath
import re

from ...files import PackageFiles
from ...package.launch.uncalled_functions import bodies, unnamed
from ...source import Span
from ..reached_definitions import is_collected
from .launch_context import LaunchContext
from .launch_modules import is_imported


def is_left(scope: LaunchContext, place: Span) -> bool:
    """Return whether a place is in a function that the file itself does not call, in a file that no other one takes."""
    file = scope.file.python
    if file is None or not any(each.contains(place) for each in bodies(file, unnamed(file))):
        return False
    return not (is_for_others(scope.files, scope.file.path) or is_taken(scope))


def is_for_others(files: PackageFiles, path: str) -> bool:
    """Return whether a file is a module of a Python package, which anybody may import, or one that pytest collects."""
    return files.has_file(posixpath.join(posixpath.dirname(path), "__init__.py")) or is_collected(path)


def is_taken(scope: LaunchContext) -> bool:
    """Return whether Python code of any package imports a module of the name, or code of this one has it in quotes."""
    path = scope.file.path
    if is_imported(path, scope.files):
        return True
    stem = posixpath.basename(path).removesuffix(".py")
    taken = {each for facts in (scope.package, *scope.workspace.packages) for each in facts.taken_names}
    if any(stem in (*module.split("."), name) for module, name in taken):
        return True
    quoted = re.compile(rf"""['"/.]{re.escape(stem)}(?:\.py)?['"]""")
    others = (each for each in scope.files.paths if each.endswith(".py") and each != path)
    return any(quoted.search(scope.files.readable_text(each)) for each in others)
