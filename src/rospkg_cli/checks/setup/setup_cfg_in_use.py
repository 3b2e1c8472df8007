"""Rule input: a setup.cfg, and whether setuptools ever reads it."""

from __future__ import annotations

from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.package_facts import PackageFacts
from ...package.setup.setup_cfg import SetupCfg

INSTALLS_PYTHON = "ament_python_install_package"


@dataclass(frozen=True)
class SetupCfgInUse:
    """A setup.cfg, and the build of its package."""

    cfg: SetupCfg
    facts: PackageFacts
    cmake: CMake | None

    @property
    def is_read(self) -> bool:
        """Whether the build runs setuptools: a package of CMake does so for `ament_python_install_package()` alone."""
        if self.facts.build_type in ("", "ament_python"):
            return True
        return self.cmake is not None and bool(self.cmake.named(INSTALLS_PYTHON))
