"""Why Python finds modules where their source lies, though no build installs them."""

from __future__ import annotations

from ..files import PackageFiles
from .depends.own_requirements import links_own_folder
from .repository.container_files import OF_CONTAINER, OF_SCRIPT, OF_WORKFLOW, files_called
from .repository.python_path_settings import ON_PATH, has_on_python_path

BY_PIP = "; a text here has pip install the source folder itself, where Python finds it"


def why_found(files: PackageFiles, folder: str) -> str:
    """Return why Python looks into a folder of a package, "" for its own; nothing where no text is known to say so."""
    if has_on_python_path(files, folder):
        return ON_PATH
    return BY_PIP if is_linked_by_pip(files) else ""


def is_linked_by_pip(files: PackageFiles) -> bool:
    """Return whether a text has pip install links to the package's folder (`pip install -e .`)."""
    if not (files.exists("setup.py") or files.exists("pyproject.toml")):
        return False
    own = f"{files.folder}/" if files.folder else ""
    for whole, path in files_called(files, OF_CONTAINER, OF_SCRIPT, OF_WORKFLOW):
        place = path.removeprefix(own) if path.startswith(own) else f"/{path}"
        if links_own_folder(files, place, whole.readable_text(path)):
            return True
    return False
