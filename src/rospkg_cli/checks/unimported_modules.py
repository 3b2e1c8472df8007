"""Rule input: the modules of a library that neither its own code nor its users in the workspace import."""

from __future__ import annotations

from functools import cached_property

from ..light_dataclasses import dataclass
from ..package.package_facts import PackageFacts
from ..package.workspace import Workspace
from .module_mentions import PAGES
from .python.installed_modules import InstalledModules
from .reached_modules import ReachedModules


@dataclass(frozen=True)
class UnimportedModules:
    facts: PackageFacts
    workspace: Workspace
    installed: InstalledModules
    reached: ReachedModules

    def has(self, path: str) -> bool:
        """Return whether a file is a module of a package without programs, of which others import only other modules.

        Where no other package of the workspace imports any, the package is for users outside of it.
        """
        return self.is_used and self.is_unimported(path)

    def is_unimported(self, path: str) -> bool:
        """Return whether a file is a module of a package without programs that nothing in the workspace imports."""
        module = self.installed.names.get(path, "")
        return bool(module) and self.reached.is_library and module not in self.imported

    def is_skipped_by_importers(self, path: str) -> bool:
        """Return whether nothing here imports or names a module of a package without programs, while other modules of
        the package are imported.

        It is asked of modules whose import fails: such a module is not imported elsewhere either.
        """
        module, sources = self.installed.names.get(path, ""), self.installed.sources
        if (
            not module
            or not self.reached.is_library
            or module in self.imported
            or any(self.reached.mentions.naming(path))
        ):
            return False
        return any(not sources[each].endswith("__init__.py") for each in self.imported if each in sources)

    @cached_property
    def is_used(self) -> bool:
        return not self.installed.sources.keys().isdisjoint(self.taken)

    @cached_property
    def imported(self) -> frozenset[str]:
        """The modules that are imported, named or started by their path, and all that these import."""
        waiting = [*self.reached.all, *self.taken]
        waiting += [module for module, source in self.installed.sources.items() if self.is_shown(module, source)]
        return self.reached.imports.imported_from(waiting, around=True)

    @cached_property
    def taken(self) -> list[str]:
        """What other packages of the workspace import, each name as one of a module as well."""
        others = (each for each in self.workspace.packages if each.name != self.facts.name)
        found = {taken for each in others for taken in each.taken_names}
        return [name for module, inner in found for name in (module, f"{module}.{inner}")]

    def is_shown(self, module: str, source: str) -> bool:
        """Return whether a module may be started by its path, or a page has its dotted name or its path."""
        files = self.installed.files
        pages = (files.readable_text(path) for path in files.paths if path.endswith(PAGES))
        return "__main__" in files.readable_text(source) or any(module in text or source in text for text in pages)
