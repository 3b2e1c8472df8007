"""What CMake requires by its name, so that it stops before the compiler misses a header."""

from __future__ import annotations

from collections.abc import Iterator

from ...package.cmake.cmake_project import CMake
from ...package.cmake.find_package import FoundPackage

OF_CMAKE = frozenset({
    "ALSA", "Armadillo", "BLAS", "BZip2", "Boost", "Bullet", "CUDA", "CUDAToolkit", "CURL", "Curses", "Doxygen",
    "EXPAT", "FLTK", "Freetype", "GDAL", "GLEW", "GLUT", "GSL", "GTK2", "GTest", "Git", "HDF5", "ImageMagick", "JPEG",
    "Java", "LAPACK", "LTTngUST", "LibArchive", "LibLZMA", "LibXml2", "Lua", "MPI", "OpenAL", "OpenCL", "OpenGL",
    "OpenMP", "OpenSSL", "OpenSceneGraph", "OpenThreads", "PNG", "PkgConfig", "Protobuf", "Python", "Python3",
    "PythonInterp", "PythonLibs", "SDL", "SQLite3", "SWIG", "TIFF", "Threads", "Vulkan", "X11", "XercesC", "ZLIB",
})  # fmt: skip
"""The packages that modules of CMake itself look for (FindBoost.cmake)."""
ASKS = ("pkg_check_modules", "pkg_search_module")
VERSION = ("<", ">", "=")


def required_packages(cmake: CMake) -> Iterator[str]:
    """Yield the packages that CMake certainly requires."""
    return (found.name for found in cmake.packages if found.is_required and not found.call.maybe)


def stops_with(found: FoundPackage, cmake: CMake) -> str:
    """Return with what CMake stops where a package is missing: at the call itself, or where it is used."""
    if found.is_required:
        is_module = found.name in OF_CMAKE and not {"CONFIG", "NO_MODULE"}.intersection(found.call.texts)
        text = f"Could NOT find {found.name}" if is_module else "Could not find a package configuration file"
        return f'with "{text}"'
    if any(found.name in call.texts for call in cmake.named("ament_target_dependencies")):
        return 'at `ament_target_dependencies`: "the passed package name … was not found before"'
    for call in cmake.named("target_link_libraries"):
        for word in call.words[1:]:
            if word.text.startswith(f"{found.name}::") and not (word.maybe or call.maybe):
                return f'at the link with `{word.text}`: "the target was not found"'
    return "where it is used"


def required_modules(cmake: CMake, *, with_tests: bool = True) -> Iterator[str]:
    """Yield the modules of pkg-config that CMake certainly requires."""
    for call in cmake.named(*ASKS):
        if "REQUIRED" in call.texts and not call.maybe and (with_tests or not call.testing):
            yield from map(without_version, call.texts[1:])


def without_version(module: str) -> str:
    """Return a module of pkg-config without its limit: `libcurl` of `libcurl>=7`."""
    return min((module.partition(sign)[0].strip() for sign in VERSION), key=len)
