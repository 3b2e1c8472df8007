"""Names of dependencies that are wrong in any case, with or without a fetched index, and what is intended (DEP001)."""

from __future__ import annotations

from collections.abc import Callable

from ...light_dataclasses import dataclass
from ...package.dependency import Dependency
from ...ros.aliases import key_for_apt, key_for_pip
from ...ros.imports import STANDARD
from ...ros.names import Names
from ...ros.read_table import rows
from ...ros.rosdep import CODENAMES, NOT_THERE
from .declared_dependencies import DeclaredDependencies
from .intended_names import key_of_cmake_name
from .plain_projects import advice_for_project
from .similar_names import SimilarNames

PYTHON_TAGS = frozenset({"exec_depend", "test_depend", "run_depend"})
UNKNOWN_KEY = "Cannot locate rosdep definition for [{}]"
PYTHON_2, PYTHON_3 = "python-", "python3-"


@dataclass(frozen=True, slots=True)
class WrongDependencyName:
    """What is wrong with a name, as the rest of a sentence (`is its name on PyPI`), and what to write instead."""

    reason: str
    suggestion: str | None = None
    advice: str = ""
    """What to do; "" where it is to write the suggestion."""
    rosdep_error: str = UNKNOWN_KEY
    """What rosdep prints; `{}` is the name."""
    parts: tuple[str, ...] = ()
    """The names, where one tag holds several."""


def wrong_name(
    declared: DeclaredDependencies, dependency: Dependency, *, misspelt: bool = True
) -> WrongDependencyName | None:
    """Return what is wrong with a name that no package and no key has; None where nothing is certain.

    A rosdep key without any rule for a supported Ubuntu may be asked for as well. Without `misspelt` similar names are
    left aside.
    """
    finders = (*ELSEWHERE, of_typo) if misspelt else ELSEWHERE
    return next((found for find in finders if (found := find(declared, dependency)) is not None), None)


def several(declared: DeclaredDependencies, dependency: Dependency) -> WrongDependencyName | None:
    parts = dependency.name.replace(",", " ").split()
    if len(parts) < 2:
        return None
    lines = " ".join(f"<{dependency.tag}>{part}</{dependency.tag}>" for part in parts)
    return WrongDependencyName(f"is {len(parts)} names in one tag", advice=f"write {lines}", parts=tuple(parts))


def of_cmake(declared: DeclaredDependencies, dependency: Dependency) -> WrongDependencyName | None:
    key = key_of_cmake_name(dependency.name)
    return WrongDependencyName("is what CMake calls it", key) if key else None


def of_python_itself(declared: DeclaredDependencies, dependency: Dependency) -> WrongDependencyName | None:
    """Debian leaves some modules of Python to packages of their own: `tkinter` to `python3-tk`."""
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


def of_ubuntu(declared: DeclaredDependencies, dependency: Dependency) -> WrongDependencyName | None:
    key = key_for_apt(dependency.name, declared.workspace.index)
    return WrongDependencyName("is its name in Ubuntu", key) if key is not None else None


def of_family(declared: DeclaredDependencies, dependency: Dependency) -> WrongDependencyName | None:
    if declared.workspace.folder_of_project(dependency.name):
        return None
    member = SimilarNames(declared.workspace).with_family_prefix(dependency.name)
    return WrongDependencyName("is no known ROS package, here or elsewhere", member) if member is not None else None


def of_typo(declared: DeclaredDependencies, dependency: Dependency) -> WrongDependencyName | None:
    intended = SimilarNames(declared.workspace).intended(dependency.name)
    if intended is None or without_version(intended) == without_version(dependency.name):
        return None
    start = "is no known ROS package or rosdep key"
    if for_project := advice_for_project(dependency.name, declared.workspace):
        return WrongDependencyName(start, advice=for_project)
    return WrongDependencyName(start, intended, f"did you mean `{intended}`?")


def without_version(name: str) -> str:
    """Return a name without the digits at its end: or before `-dev`: `gz-plugin3` is no misspelt `gz-plugin2`."""
    bare = name.removesuffix("-dev")
    return bare.rstrip("0123456789.-_") + name[len(bare) :]


ELSEWHERE: tuple[Callable[[DeclaredDependencies, Dependency], WrongDependencyName | None], ...] = (
    several, of_cmake, of_python_itself, of_python_2, of_pip, of_module, of_ubuntu, of_family,
)  # fmt: skip


def is_for_python(declared: DeclaredDependencies, dependency: Dependency) -> bool:
    """Return whether a name may be one of PyPI: in a C++ package it may be a private dependency."""
    if declared.facts.build_type == "ament_python" or "-" in dependency.name:
        return True
    return all(each.tag in PYTHON_TAGS for each in declared.manifest.dependencies if each.name == dependency.name)


def is_of_python_2(key: str, index: Names) -> bool:
    """Return whether rosdep has a key for all of Ubuntu whose package went with Python 2; another is for 3."""
    has_other = is_installable(PYTHON_3 + key.removeprefix(PYTHON_2), index)
    return key.startswith(PYTHON_2) and has_other and "apt" in index.keys.get(key, ())


def is_installable(key: str, index: Names) -> bool:
    """Return whether rosdep has a rule for a key on some supported Ubuntu."""
    return any(way != NOT_THERE for way in index.keys.get(key, ()))
