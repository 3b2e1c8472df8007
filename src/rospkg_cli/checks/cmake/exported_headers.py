"""Rule input: the headers that a package exports, and who may use them."""

from __future__ import annotations

from ...light_dataclasses import dataclass
from ...package.cmake.installed_headers import TARGETS, PublicHeaders
from ...package.workspace import Workspace

DESCRIPTIONS = "pluginlib_export_plugin_description_file"
LIBRARIES = ("ament_export_libraries", *TARGETS)


@dataclass(frozen=True)
class ExportedHeaders:
    headers: PublicHeaders
    workspace: Workspace

    @property
    def may_be_used(self) -> bool:
        """Whether the headers are for others: with a library, with nothing else at all, or for a known package."""
        package = self.headers.package
        built = [target for target in package.cmake.targets if target.is_built]
        has_library = any(target.is_library for target in built) or not built
        if has_library and (package.cmake.named(*LIBRARIES) or not built):
            return True
        return self.is_built_against

    @property
    def are_of_plugins(self) -> bool:
        """Whether the package is loaded as plugins, and no package of the workspace builds against it."""
        return bool(self.headers.package.cmake.named(DESCRIPTIONS)) and not self.is_built_against

    @property
    def is_built_against(self) -> bool:
        """Whether a package of the workspace that has targets of its own depends on this one to build."""
        name = self.headers.package.facts.name
        tags = ("depend", "build_depend", "build_export_depend")
        compiled = (each for each in self.workspace.needing(name) if each.is_ament and each.is_compiled)
        needs = (need for facts in compiled for need in facts.dependencies)
        return any(need.name == name and need.tag in tags for need in needs)
