"""Where the Python code of a package is, and what it is imported as."""

from __future__ import annotations

import posixpath
from collections import Counter

from ..change import ChangeError
from ..light_dataclasses import dataclass
from ..package.cmake.cmake_project import CMake
from ..package.manifest import Manifest
from ..package.package import Package
from ..package.setup.find_packages import dotted
from ..package.setup.setup_py import SetupPy
from .entry_point import setup_of
from .rendered import identifier


@dataclass(frozen=True)
class PythonHome:
    """A Python package that is installed, or is to be."""

    module: str
    """As it is imported: `my_pkg`, `my_pkg.nodes`."""
    folder: str

    def path(self, name: str) -> str:
        return posixpath.join(self.folder, f"{name}.py")


def python_home(package: Package, manifest: Manifest) -> PythonHome:
    """Return where a node in Python goes in a package of type ament_python; raises ChangeError where nowhere."""
    setup = setup_of(package)
    name = identifier(manifest.name)
    chosen = chosen_package(setup, name)
    if chosen is None:
        raise ChangeError(
            f"setup.py installs no Python package: list `{name}` in `packages`, with `{name}/__init__.py`, and run the "
            "command again"
        )
    return PythonHome(checked(chosen), setup.folder_of(chosen))


def checked(module: str) -> str:
    """Return the name of a module; raises ChangeError for one that can't be imported."""
    if not all(part.isidentifier() for part in module.split(".")):
        raise ChangeError(f"`{module}` is no name that Python can import; rename it, and run the command again")
    return module


def chosen_package(setup: SetupPy, name: str) -> str | None:
    """Return the package that is called like the manifest says, else that of most executables, else the first."""
    packages = [dotted(each.text) for each in setup.packages]
    there = [each for each in packages if setup.kind(posixpath.join(setup.folder_of(each), "__init__.py")) == "file"]
    if name in there:
        return name
    homes = Counter(each.module.rpartition(".")[0] for each in setup.entry_points if each.is_script)
    used = [home for home, _ in homes.most_common() if home in there]
    return next(iter([*used, *there]), None)


def cmake_python_home(cmake: CMake | None, manifest: Manifest) -> PythonHome:
    """Return the Python package that CMake installs, or the one that it is to install."""
    name = identifier(manifest.name)
    for call in cmake.named("ament_python_install_package") if cmake else ():
        if call.words and call.words[0].is_known:
            folders = [call.texts[at + 1] for at, text in enumerate(call.texts[:-1]) if text == "PACKAGE_DIR"]
            return PythonHome(checked(call.words[0].text), folders[0] if folders else call.words[0].text)
    if generates_interfaces(cmake):  # as the Python package of that name
        name = f"{name}_nodes"
    return PythonHome(name, name)


def generates_interfaces(cmake: CMake | None) -> bool:
    return cmake is not None and bool(cmake.named("rosidl_generate_interfaces"))
