"""Rule input: the headers that a package exports, and who may use them."""

from __future__ import annotations

from ...light_dataclasses import dataclass
from ...package.cmake.installed_headers import TARGETS, PublicHeaders
from ...package.workspace import Workspace

LIBRARIES = ("ament_export_libraries", *TARGETS)


@dataclass(frozen=True)
class ExportedHeaders:
    headers: PublicHeaders
    workspace: Workspace

    @property
    def may_be_used(self) -> bool:
        """Whether the headers are for others: with a library, with nothing else at all, or for a known package."""
        package = self.headers.package
        cmake, name = package.cmake, package.facts.name
        if cmake.named(*LIBRARIES) or not any(target.is_built for target in cmake.targets):
            return True
        tags = ("depend", "build_depend", "build_export_depend")
        compiled = (facts for facts in self.workspace.packages if facts.is_ament and not facts.is_metapackage)
        needs = (need for facts in compiled for need in facts.dependencies)
        return any(need.name == name and need.tag in tags for need in needs)
