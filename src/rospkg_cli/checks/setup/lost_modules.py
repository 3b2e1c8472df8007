"""Rule input: modules of a package that no build installs, and whether anybody misses them."""

from __future__ import annotations

from ...light_dataclasses import dataclass
from .module_tree import ModuleTree
from .started_entry_points import StartedEntryPoints

LEFT = "; nothing here starts the programs that import it, as it does others of the package"
BY_PIP = "; a text here has pip install the source folder itself, where Python finds it"


@dataclass(frozen=True)
class LostModules:
    tree: ModuleTree
    programs: StartedEntryPoints

    def left(self, package: str) -> str:
        """Return that nothing starts the programs whose start needs a Python package; "" where one may be."""
        return LEFT if self.programs.left_all(self.tree.started.starting(package)) else ""

    def why_found(self, package: str) -> str:
        """Return why Python finds a Python package where its source lies; "" where nothing is known to have it so."""
        from ..told_python_paths import ON_PATH, has_on_python_path  # what findings alone need

        files, setup = self.tree.package.files, self.tree.setup
        top = setup.folder_of(package.partition(".")[0])
        if has_on_python_path(files, top.rpartition("/")[0]):
            return ON_PATH
        return BY_PIP if self.is_installed_by_pip else ""

    @property
    def is_installed_by_pip(self) -> bool:
        """Whether a text has pip install links to the package's folder (`pip install -e .`)."""
        from ..container_files import OF_CONTAINER, OF_SCRIPT, OF_WORKFLOW, files_called
        from ..depends.own_requirements import links_own_folder

        files = self.tree.package.files
        own = f"{files.folder}/" if files.folder else ""
        called = files_called(files, OF_CONTAINER, OF_SCRIPT, OF_WORKFLOW)
        places = (
            (path.removeprefix(own) if path.startswith(own) else f"/{path}", whole, path) for whole, path in called
        )
        return any(links_own_folder(files, place, whole.readable_text(path)) for place, whole, path in places)
