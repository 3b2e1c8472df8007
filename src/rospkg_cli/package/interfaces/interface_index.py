"""The names of a package's interfaces for PackageFacts, and whether these are all."""

from __future__ import annotations

from ...files import ReaderInput
from ...ros.interfaces import KINDS
from ..cmake.build import is_built_with_cmake
from ..cmake.cmake_project import CMake
from ..file_role import role_of
from .reader import interface_paths

SUFFIXES = tuple(f".{kind}" for kind in KINDS)
GENERATED = tuple(f".{kind}{suffix}" for kind in (*KINDS, "idl") for suffix in (".in", ".em", ".j2", ".template"))


def interface_names(reading: ReaderInput) -> tuple[frozenset[str], bool]:
    """Return `msg/Name`, `srv/Name` … of all interfaces of a package, and whether these are all.

    rosidl_adapter writes `msg/Name.idl` for a .msg in any folder; an .idl file stays in its own. Files that CMake lists
    count even if they are missing, which has its own finding.
    """
    found = {f"{path.rpartition('.')[2]}/{stem(path)}" for path in interface_paths(reading.files)}
    for path in reading.files.paths:
        folder = path.rpartition("/")[0].rpartition("/")[2]
        if path.endswith(".idl") and folder in KINDS and role_of(path) == "run":
            found.add(f"{folder}/{stem(path)}")
    found |= {f"{path.rpartition('.')[2]}/{stem(path)}" for path in listed_paths(reading)}
    complete = not any(path.endswith(GENERATED) for path in reading.files.paths) and all_are_own(reading)
    return frozenset(found), complete


def stem(path: str) -> str:
    return path.rpartition("/")[2].rpartition(".")[0]


def listed_paths(reading: ReaderInput) -> set[str]:
    """Return the .msg, .srv and .action files that CMake generates interfaces of."""
    cmake = reading.parts(CMake).only if is_built_with_cmake(reading) else None
    return {path for path in cmake.generated_interfaces if path.endswith(SUFFIXES)} if cmake is not None else set()


def all_are_own(reading: ReaderInput) -> bool:
    """Return whether all arguments of rosidl_generate_interfaces are known files of the package."""
    if not is_built_with_cmake(reading):
        return True
    cmake = reading.parts(CMake).only
    if cmake is None or not cmake.is_complete:
        return False
    listed = [(word, target) for target in cmake.interface_targets for word in target.files]
    return all(target.path_of(word) is not None for word, target in listed)
