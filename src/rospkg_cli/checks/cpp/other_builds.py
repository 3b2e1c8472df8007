"""Files by which something other than the package's own CMake compiles sources, or has done so."""

from __future__ import annotations

import posixpath
import re

from ...files import PackageFiles
from ...lazy_regex import regex

NAMES = frozenset(
    "CMakeLists.txt Makefile makefile GNUmakefile Makefile.am meson.build SConstruct SConscript BUILD BUILD.bazel "
    "configure.ac wscript platformio.ini build.gradle".split()
)
ENDINGS = (".pro", ".vcxproj", ".mk", ".ino", ".uvprojx", ".ioc")
ALL = regex(r"\*\.c\w*|%\.(?:o|c\w*)")
"""A pattern of a Makefile that takes whatever lies there."""
BUILT = regex(r".*\.(?:a|so(?:\.\d+)*|lib|dylib)")


def is_built_elsewhere(files: PackageFiles, path: str, read: frozenset[str]) -> bool:
    """Return whether a file of another build lies in a folder around a source, below that of the package.

    One next to package.xml counts where it has the name of the source, or takes all there are. `read` holds the files
    of CMake that the package's own build reads.
    """
    *folders, name = path.split("/")
    around = frozenset("/".join(folders[: n + 1]) for n in range(len(folders)))
    builds = [each for each in files.paths if is_build_file(each) and each not in read]
    if any(posixpath.dirname(each) in around for each in builds):
        return True
    stem = re.compile(rf"(?<![\w-]){re.escape(posixpath.splitext(name)[0])}(?![\w-])")
    tops = (each for each in builds if "/" not in each and each != "CMakeLists.txt")
    return any(stem.search(text) or ALL.search(text) for text in map(files.readable_text, tops))


def is_build_file(path: str) -> bool:
    return posixpath.basename(path) in NAMES or path.endswith(ENDINGS)


def has_built_libraries(files: PackageFiles) -> bool:
    """Return whether a compiled library lies in the package, which may have what its sources define."""
    return any(BUILT.fullmatch(posixpath.basename(path)) for path in files.paths)
