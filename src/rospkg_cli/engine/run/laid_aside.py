"""Levels of findings in folders for what is no longer used (`old/`, `not_in_use/`)."""

from __future__ import annotations

from collections.abc import Callable

from ...finding import Severity
from ...package.file_role import is_set_aside

BUILDING = (
    *("XML", "CMK", "WSP", "DEP104", "SET103", "SET205", "SET302", "SET308"),
    *("IDL001", "IDL002", "IDL003", "IDL004", "IDL006", "IDL007", "IDL014"),
)
"""Families and rules whose errors stop a build: colcon builds packages that are laid aside, too."""
BUILT = frozenset({"CMK003", "CMK104", "CMK105", "CMK108", "CMK109", "CMK111", "CMK128", "XML107", "XML306"})
"""Those among them whose errors appear only once something is started."""
TEMPLATE = "{{"
"""Part of the names of template folders (cookiecutter, copier), whose contents are not built as they are."""
BUILD_FILES = ("package.xml", "CMakeLists.txt", "setup.py", ".cmake")
OF_RUNS = ("DEP", "LCH", "PRM", "URD", "IDL010", "IDL011")
"""Families about launches and runs, and about what other machines lack, and rules about Python."""
OPENED = ("PRM", "URD", "IDL010", "IDL011")
"""Those about files that launch files open, or others import, by name."""


def stops_build(code: str, path: str) -> bool:
    """Return whether an error of a rule in a file stops the build."""
    return (code.startswith(BUILDING) and code not in BUILT) or (code == "RPK001" and path.endswith(BUILD_FILES))


def level_aside(code: str, level: Severity, path: str, folder: str, is_left: Callable[[], bool]) -> Severity:
    """Return the level of a hit by where its file lies, from the root of the run, in the package of a folder.

    A fault in a package that is laid aside does no harm unless it stops the build. In a package in use, code that is
    laid aside may still be imported, so that a fault that ends it is a warning.
    """
    if TEMPLATE in path:
        return Severity.INFO
    is_mild = level is Severity.INFO or (level is Severity.ERROR and stops_build(code, path))
    if is_mild or not is_set_aside(path):
        return level
    if is_set_aside(f"{folder}/"):
        return Severity.INFO
    if not code.startswith(OF_RUNS) and code != "RPK001":
        return level
    may_be_met = level is Severity.ERROR and path.endswith(".py") and not code.startswith(OPENED)
    return Severity.WARNING if may_be_met and not is_left() else Severity.INFO
