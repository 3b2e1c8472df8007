"""A package that ament_cmake builds: its manifest, its CMake, and its facts."""

from __future__ import annotations

from ...light_dataclasses import dataclass
from ...ros.distros import Targets
from ..manifest import Manifest
from ..package_facts import PackageFacts
from .cmake_project import CMake


@dataclass(frozen=True)
class CMakePackage:
    manifest: Manifest
    cmake: CMake
    facts: PackageFacts

    @property
    def is_ament(self) -> bool:
        return self.facts.build_type == "ament_cmake"


@dataclass(frozen=True)
class CMakeForTargets:
    package: CMakePackage
    targets: Targets
