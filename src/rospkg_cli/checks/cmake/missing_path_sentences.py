"""What happens where CMake names a path that is not there, as the end of a sentence (CMK102)."""

from __future__ import annotations

from ...package.cmake.referenced_paths import ReferencedPath

PLURAL = {"folder": "the build stops when it installs (git keeps no empty folder); add files to them, or remove them"}


def consequence(named: ReferencedPath) -> str:
    match named.use:
        case "source":
            return 'CMake stops with "Cannot find source file"; name an existing file, or remove it'
        case "test":
            return f"`{named.call.name}` stops CMake, since colcon builds with tests on; name an existing test"
        case "subdirectory":
            return "`add_subdirectory` stops CMake; name a folder with a CMakeLists.txt"
        case "include":
            return "`include` stops CMake; name an existing file"
        case "extras":
            return f"`{named.call.name}` stops CMake; name an existing file, or take it out of CONFIG_EXTRAS"
        case "parameters":
            return "the build stops, since nothing makes it; name an existing file of parameters"
        case "matching":
            return "with FILES_MATCHING nothing is installed, without a word; name an existing folder, or remove it"
        case "folder":
            return (
                "the build stops when it installs (git keeps no empty folder); add it with a file in it, or remove it"
            )
        case _ if named.call.name.startswith("pluginlib_"):
            return "CMake stops at once; name an existing plugin description"
        case _:
            return "the build stops when it installs; name an existing file, or remove it"
