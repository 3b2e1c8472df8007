"""Rule input: packages of ROS among the requirements in install_requires."""

from __future__ import annotations

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.setup.setup_text import SetupText
from .python_package import PythonPackage

REQUIREMENT = regex(r"[A-Za-z0-9][A-Za-z0-9_.-]*")


@dataclass(frozen=True)
class InstallRequires:
    package: PythonPackage

    @property
    def ros_requirements(self) -> tuple[tuple[SetupText, str], ...]:
        """The requirements that no Python distribution satisfies: interfaces, and CMake packages without Python."""
        found = []
        for requirement in self.package.setup.texts("install_requires"):
            match = REQUIREMENT.match(requirement.text)
            name = match.group() if match else ""
            facts = self.package.workspace.named(name)
            built = facts is not None and facts.build_type in ("ament_cmake", "cmake") and facts.knows("modules")
            if name.endswith("_msgs") or (facts is not None and built and not facts.modules):
                found.append((requirement, name))
        return tuple(found)
