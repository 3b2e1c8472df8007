"""What `rospkg new` writes or would write, where there may be a folder of that name."""

from __future__ import annotations

from pathlib import Path

from ...control_characters import visible
from ...scaffold.answers_record import RECORD
from ...scaffold.existing_folder import FolderDifference, write_into
from ...scaffold.lacking_lines import lacking_lines
from ...scaffold.plan import Plan
from ...scaffold.render import RenderedFile
from ...scaffold.write import is_there, write_folder
from ...tree import TreeEntry
from ..diff import diff


def write_plan(target: Path, plan: Plan, there: FolderDifference, existing: str) -> str:
    """Write the package; return a sentence on what became of a folder that was there, else ""."""
    if not is_there(target):
        write_folder(target, plan.files)
        return ""
    kept = write_into(target, there, existing == "force")
    if not there.same and not there.other:
        return ""
    left = len(there.same) + (0 if existing == "force" else len(there.other))
    said = f"{counted(len(there.missing))} written, {left} left as {'it was' if left == 1 else 'they were'}"
    if kept:
        return f"{said}, {len(there.other)} replaced: what was there is in `{kept}`"
    return said + what_lacks(there, existing)


def what_lacks(there: FolderDifference, existing: str) -> str:
    """Return which files were left alone and lack what was asked for: a new node is not built by its source alone."""
    lacking = [visible(file.path) for file, before in there.other if lacking_lines(before, file.entry)]
    lacking = [path for path in lacking if path != RECORD]
    if existing == "force" or not lacking:
        return ""
    names, verb = ", ".join(f"`{path}`" for path in lacking), "lacks" if len(lacking) == 1 else "lack"
    return f"; {names} {verb} what would be written there: --diff shows it, and `rospkg add` adds a node in its place"


def counted(files: int) -> str:
    return "1 file" if files == 1 else f"{files} files"


def show_difference(plan: Plan, there: FolderDifference, existing: str) -> int:
    """Show what would be written; return 1 where that is anything, else 0."""
    changes: list[tuple[RenderedFile, TreeEntry | None]] = [(file, None) for file in there.missing]
    changes += there.other if existing != "skip" else ()
    for file, before in sorted(changes, key=lambda change: change[0].path):
        path = f"{plan.answers.name}/{file.path}"
        try:
            print(diff(path, before, file.entry), end="")
        except UnicodeError:
            print(f"Binary files a/{visible(path)} and b/{visible(path)} differ")
    return 1 if changes else 0
