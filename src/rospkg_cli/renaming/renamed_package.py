"""A package that gets another name, and what follows the name."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cached_property

from ..light_dataclasses import dataclass
from ..package.cmake.cmake_project import CMake
from ..package.collect_facts import collect_facts
from ..package.package import Package
from ..ros.distros import Targets
from .derived_paths import derived_moves, project_affixes
from .patterns import ALONE, Affixes, pattern

LIBRARY = r"""\b\w*add_(?:library|module)\s*\(\s*(?:"?%NAME%"?|"?\$\{PROJECT_NAME\}"?)[\s)]"""
HEADERS = (".h", ".hh", ".hpp", ".hxx", ".ipp", ".tpp", ".inl", ".cuh", ".inc")
BUILD_FILES = ("CMakeLists.txt", ".cmake")


@dataclass(frozen=True)
class RenamedPackage:
    """The old name and the new one. Folders and paths are those from before, relative to the root."""

    old: str
    new: str
    package: Package
    others: frozenset[str] = frozenset()
    """The headers `OLD/…` that lie in folders which keep their names, without the `OLD/`."""

    @property
    def folder(self) -> str:
        return self.package.folder

    @cached_property
    def moves(self) -> dict[str, str]:
        """The files and folders that carry the name because the package does, relative to it, and what they become."""
        found = dict.fromkeys(moved_paths(self.package.files.paths, self.old), self.new)
        return found | dict(derived_moves(self.package.files, self.old, self.new))

    @property
    def moved(self) -> frozenset[str]:
        return frozenset(self.moves)

    @cached_property
    def has_interfaces(self) -> bool:
        """Whether messages are generated: then headers, a namespace and a module of that name are."""
        return any("rosidl_generate_interfaces" in text for text in self._build_texts)

    @cached_property
    def submodules(self) -> frozenset[str]:
        """What a Python module of the package's name holds; empty where there is none."""
        inner = [path.partition(f"{each}/")[2] for each in self._modules for path in self._below(each)]
        names = {path.partition("/")[0].removesuffix(".py") for path in inner}
        return frozenset(names | {"msg", "srv", "action"} if self.has_interfaces else names)

    @cached_property
    def has_module(self) -> bool:
        return bool(self._modules) or self.has_interfaces

    @cached_property
    def has_library(self) -> bool:
        """Whether CMake builds a library, or another target, of the package's name."""
        cmake = self.package.parts(CMake).only
        is_target = cmake is not None and any(each.name == self.old for each in cmake.targets)
        return is_target or any(pattern(LIBRARY, self.old).search(text) for text in self._build_texts)

    @property
    def has_executable(self) -> bool:
        """Whether there is an executable of the package's name that is no file of this name."""
        return ALONE[0] in self.executables

    @cached_property
    def executables(self) -> tuple[Affixes, ...]:
        """The executables that follow the name of the package: that of its name, and `${PROJECT_NAME}_node`."""
        known = collect_facts(self.package, Targets(), "", "").executables
        files = {path.rpartition("/")[2] for path in self._paths if path not in self.moved}
        names = {each: f"{each[0]}{self.old}{each[1]}" for each in (*ALONE, *self._affixes)}
        return tuple(each for each, name in names.items() if name in known and name not in files)

    @property
    def libraries(self) -> tuple[Affixes, ...]:
        """The libraries and other targets that may follow the name of the package."""
        return (*ALONE, *self._affixes) if self.has_library else self._affixes

    @cached_property
    def _affixes(self) -> tuple[Affixes, ...]:
        return project_affixes(self.package.files)

    @property
    def _paths(self) -> tuple[str, ...]:
        return self.package.files.paths

    @cached_property
    def _modules(self) -> list[str]:
        return [
            each for each in self.moved if not each.startswith(("include/", "resource/")) and "include/" not in each
        ]

    @cached_property
    def _build_texts(self) -> list[str]:
        return [self.package.files.readable_text(path) for path in self._paths if path.endswith(BUILD_FILES)]

    def _below(self, folder: str) -> list[str]:
        return [path for path in self._paths if path.startswith(f"{folder}/")]


def moved_paths(paths: Iterable[str], name: str) -> frozenset[str]:
    """Return the folder of headers, the Python module and the marker of a package, as far as they have its name."""
    known = frozenset(paths)
    found = {path for path in (f"resource/{name}",) if path in known}
    for path in known:
        parts = path.split("/")
        for at, part in enumerate(parts[:-1]):
            folder = "/".join(parts[: at + 1])
            if part == name and (parts[at - 1 : at] == ["include"] or is_module(folder, known)):
                found.add(folder)
    return frozenset(found)


def is_module(folder: str, paths: frozenset[str]) -> bool:
    """Return whether a folder is a Python module of its own, in no other."""
    above = folder.rpartition("/")[0]
    if f"{above}/__init__.py".lstrip("/") in paths:
        return False
    if f"{folder}/__init__.py" in paths:
        return True
    is_package = "setup.py" in paths and above in ("", "src")
    return is_package and any(path.rpartition("/")[0] == folder and path.endswith(".py") for path in paths)


def other_headers(paths: Iterable[str], name: str, moved: Iterable[str]) -> frozenset[str]:
    """Return what lies in folders of a name that keep it; `moved` are those that don't, as `paths` from the root."""
    own, others, changed = set[str](), set[str](), frozenset(moved)
    for path in paths:
        parts = path.split("/")
        for at, part in enumerate(parts[:-1]):
            if part == name and path.endswith(HEADERS):
                inner = "/".join(parts[at + 1 :])
                (own if "/".join(parts[: at + 1]) in changed else others).add(inner)
    return frozenset(others - own)
