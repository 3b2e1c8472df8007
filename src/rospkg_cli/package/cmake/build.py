"""Whether the build reads a package's CMakeLists.txt at all."""

from __future__ import annotations

from ...files import ReaderInput
from ...languages.cmake.file import ROOT
from ...ros.distros import Targets
from ..manifest import Manifest

BUILDS_WITHOUT = frozenset({"ament_python"})
"""Build types under which no tool reads a CMakeLists.txt."""


def is_built_with_cmake(reading: ReaderInput) -> bool:
    """Return whether the build reads a CMakeLists.txt of the package."""
    if not reading.files.exists(ROOT):
        return False
    manifest = reading.parts(Manifest).only
    return manifest is None or manifest.build_type(Targets()) not in BUILDS_WITHOUT
