"""The interfaces that have a file in a package, of which its CMake surely generates nothing."""

from __future__ import annotations

from ...files import ReaderInput
from ...ros.interfaces import KINDS
from ..cmake.build import is_built_with_cmake
from ..cmake.cmake_project import CMake
from .interface_index import interface_names, stem
from .reader import interface_paths


def unlisted_interfaces(reading: ReaderInput) -> frozenset[str]:
    """Return `msg/Name` … of the files that no rosidl_generate_interfaces lists, where it is known what is listed.

    None where a listed file is not there, as it may be one of these by another name, or is made by the build.
    """
    cmake = reading.parts(CMake).only if is_built_with_cmake(reading) else None
    listed = cmake.generated_interfaces if cmake is not None else {}
    if cmake is None or not listed or not cmake.knows_interfaces or not interface_names(reading)[1]:
        return frozenset()
    if not all(map(reading.files.has_file, listed)):
        return frozenset()
    elsewhere = of_other_branches(cmake)
    paths = (path for path in interface_paths(reading.files) if path.rpartition("/")[2] not in elsewhere)
    found = {name_of(path) for path in paths if path.split("/")[-2:-1] == [path.rpartition(".")[2]]}
    idl = {f"{kind}/{stem(path)}" for path in reading.files.paths if path.endswith(".idl") for kind in KINDS}
    return frozenset(found - set(map(name_of, listed)) - idl)


def name_of(path: str) -> str:
    return f"{path.rpartition('.')[2]}/{stem(path)}"


def of_other_branches(cmake: CMake) -> set[str]:
    """Return the names of the files that calls for ROS 1, or in branches that are never taken, list."""
    catkin = cmake.named("add_message_files", "add_service_files", "add_action_files")
    return {text.rpartition("/")[2] for call in (*catkin, *cmake.unreachable) for text in call.texts}
