"""What `--with` adds for a family: in the root of its workspace, or in the folder that holds its packages."""

from __future__ import annotations

from pathlib import Path

from ..light_dataclasses import dataclass, replace
from . import ScaffoldError
from .answers import Request
from .existing_folder import FolderDifference, compare, write_into
from .extras import all_extras, with_extras, workspace_extras
from .render import RenderedFile, render
from .target_folder import workspace_of
from .template import WORKSPACE, TemplateFile, load_template
from .workspace_plan import NAME, answers_of_root


@dataclass(frozen=True)
class FamilyRoot:
    folder: Path
    files: tuple[RenderedFile, ...]

    def compared(self) -> FolderDifference:
        """Return which files are missing; raises ScaffoldError where one is there, and is another."""
        there = compare(self.folder, self.files)
        for file, _ in there.other:
            raise ScaffoldError(
                f"`{self.folder / file.path}` exists already and was left alone; leave it out of --with"
            )
        return there

    def write(self) -> None:
        """Write what is missing, all of it or nothing; raises ScaffoldError."""
        if self.files:
            write_into(self.folder, self.compared(), replace=False)


def family_root(request: Request, into: Path, distro: str) -> FamilyRoot:
    """Return the extras of a family that is written into a folder; raises ScaffoldError for unknown ones.

    Below `src/` they are for the whole workspace. Otherwise the folder is a repository that is cloned into one.
    """
    root = workspace_of(into)
    is_workspace = root != into.absolute()
    template = replace(load_template(WORKSPACE), files=())
    template = with_extras(template, request.extras, workspace_extras() if is_workspace else without_docs())
    answers = answers_of_root(Request(request.name), distro, template, [])
    return FamilyRoot(root, render(template, answers, {"repos": list_of_repositories(root)}))


def without_docs() -> dict[str, tuple[TemplateFile, ...]]:
    """Return the extras of a package that its repository has once."""
    return {name: files for name, files in all_extras().items() if name in workspace_extras()}


def list_of_repositories(root: Path) -> str:
    """Return the name of the one `.repos` file of a workspace; "" where there are none or several."""
    found = [path.name for path in root.glob("*.repos")]
    return found[0] if len(found) == 1 and NAME.fullmatch(found[0]) else ""
