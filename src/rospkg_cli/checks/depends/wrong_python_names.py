"""Names by which Python, PyPI or Python 2 know a library, and that are no rosdep keys."""

from __future__ import annotations

from ...package.dependency import Dependency
from ...ros.aliases import key_for_pip
from ...ros.imports import STANDARD
from ...ros.names import Names
from ...ros.read_table import rows
from ...ros.rosdep import CODENAMES, NOT_THERE
from .declared_dependencies import DeclaredDependencies
from .wrong_dependency_name import UNKNOWN_KEY, WrongDependencyName

PYTHON_TAGS = frozenset({"exec_depend", "test_depend", "run_depend"})

PYTHON_2, PYTHON_3 = "python-", "python3-"


def of_python_itself(declared: DeclaredDependencies, dependency: Dependency) -> WrongDependencyName | None:
    """A module of Python itself: Debian has some in packages of their own, as `tkinter` in `python3-tk`."""
    module = dependency.name.removeprefix(PYTHON_3).replace("-", "_")
    if module not in STANDARD:
        return None
    keys = (each for each in rows("imports.txt").get(module, ()) if is_installable(each, declared.workspace.index))
    if key := next(keys, None):
        return WrongDependencyName("is no rosdep key" if "-" in dependency.name else "is what Python imports", key)
    return WrongDependencyName("comes with Python itself", advice="remove the line")


def of_python_2(declared: DeclaredDependencies, dependency: Dependency) -> WrongDependencyName | None:
    """A key that rosdep had for Python 2: no Ubuntu of a supported distribution has a package for it."""
    name, index = dependency.name, declared.workspace.index
    if not name.startswith(PYTHON_2):
        return None
    rest = name.removeprefix(PYTHON_2)
    keys = (PYTHON_3 + rest, f"{PYTHON_3}{rest}-pip", key_for_pip(rest, index) or "")
    key = next((each for each in keys if is_installable(each, index)), None)
    if key is None:
        return None
    lacking = f"No definition of [{{}}] for OS version [{next(iter(CODENAMES.values()))}]"
    lacking = "E: Unable to locate package {}" if is_installable(name, index) else lacking
    return WrongDependencyName("is a key of Python 2", key, rosdep_error=lacking if index.is_key(name) else UNKNOWN_KEY)


def of_pip(declared: DeclaredDependencies, dependency: Dependency) -> WrongDependencyName | None:
    """The name on PyPI: `numpy`, or `python3-` before it."""
    name, index = dependency.name, declared.workspace.index
    bare = name.removeprefix(PYTHON_3).removesuffix("-pip") if name.startswith(PYTHON_3) else name
    key = key_for_pip(bare, index) if is_for_python(declared, dependency) else None
    return WrongDependencyName("is its name on PyPI" if bare == name else "is no rosdep key", key) if key else None


def of_module(declared: DeclaredDependencies, dependency: Dependency) -> WrongDependencyName | None:
    """The name by which Python imports it: `cv2`, or a module of a package, `rclpy.qos`."""
    top, dot, _ = dependency.name.partition(".")
    workspace = declared.workspace
    if dot and (workspace.is_available(top) or workspace.index.is_package(top)):
        return WrongDependencyName("is a module", top)
    keys = rows("imports.txt").get(dependency.name, ())[:1] if is_for_python(declared, dependency) else ()
    known = [key for key in keys if workspace.index.is_package(key) or is_installable(key, workspace.index)]
    return WrongDependencyName("is what Python imports", known[0]) if known else None


def is_for_python(declared: DeclaredDependencies, dependency: Dependency) -> bool:
    """Return whether a name may be one of PyPI; in a C++ package it may be a private package."""
    if declared.facts.build_type == "ament_python" or "-" in dependency.name:
        return True
    return all(each.tag in PYTHON_TAGS for each in declared.manifest.dependencies if each.name == dependency.name)


def is_of_python_2(key: str, index: Names) -> bool:
    """Return whether a key is for a library of Python 2 that no supported Ubuntu has, and another for Python 3."""
    has_other = is_installable(PYTHON_3 + key.removeprefix(PYTHON_2), index)
    return key.startswith(PYTHON_2) and has_other and "apt" in index.keys.get(key, ())


def is_installable(key: str, index: Names) -> bool:
    """Return whether rosdep has a rule for a key on some supported Ubuntu."""
    return any(way != NOT_THERE for way in index.keys.get(key, ()))
