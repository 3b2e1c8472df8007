"""`rospkg new --update`: the templates of today over a package that those of another day, or other answers, wrote."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path

from ...disk import DiskTree
from ...engine.fixing.write_all import write_all
from ...files import PackageFiles
from ...package.manifest import Manifest
from ...package.package import Package
from ...report.color import wants_color
from ...scaffold import ScaffoldError
from ...scaffold.answers import Request
from ...scaffold.answers_record import RECORD, read_record, with_record
from ...scaffold.plan import make_plan
from ...scaffold.template import WORKSPACE
from ...scaffold.update import UpdatedFile, answered_anew, updates
from ...scaffold.workspace_plan import plan_workspace
from .. import UsageError
from ..diff import diff
from ..streams import afterwards, say
from .file_status import FileStatus, status_lines

NOTHING_TO_DO = "nothing is to be done: it is as it would be written today"


def update(package: Path, typed: Request, dry_run: bool = False, show_diff: bool = False, color: str = "auto") -> int:
    """Merge what would be written today into a package; return the exit status, 1 where there are conflicts.

    `typed` are answers that are added to those of the package, or take their place. With `show_diff` the status is 1
    where anything would change. Raises UsageError.
    """
    package = package.resolve()
    try:
        name = name_of(package)
        record = read_record(package)
        request = answered_anew(record, name or record.request.name, typed)
        make = make_plan if name else plan_workspace
        plan = with_record(make(request, package.parent, {}))
        found = list(updates(package, record, request.name, plan.files))
    except ScaffoldError as error:
        raise UsageError(str(error)) from error
    changed = [file for file in found if file.changes]
    if show_diff:
        print("".join(shown_diff(file) for file in changed), end="")
        return 1 if changed else 0
    for note in plan.notes:
        say(note)
    if not changed:
        say(NOTHING_TO_DO)
        return 0
    if not dry_run:
        tree = DiskTree(package)
        write_all(package, tree, {file.path: file.after for file in changed}, tree.fence)
    return show(found, dry_run, wants_color(color, sys.stdout))


def name_of(package: Path) -> str:
    """Return the name that a package has today, "" for a workspace; raises ScaffoldError for what is neither."""
    if (package / RECORD).is_file() and not (package / "package.xml").exists() and is_workspace(package):
        return ""
    manifest = Package(PackageFiles(DiskTree(package), package.name)).parts(Manifest).only
    if not manifest or not manifest.name:
        raise ScaffoldError(
            f"`{package}` is no package: it has no package.xml that says its name; nor the `{RECORD}` of a workspace"
        )
    return manifest.name


def is_workspace(folder: Path) -> bool:
    return read_record(folder).request.template == WORKSPACE


def shown_diff(file: UpdatedFile) -> str:
    try:
        return diff(file.path, file.before, file.after)
    except UnicodeError:
        return f"Binary files a/{file.path} and b/{file.path} differ\n"


def show(found: Sequence[UpdatedFile], dry_run: bool, color: bool) -> int:
    lines = list(status_lines([FileStatus(file.status, file.path, file.about) for file in found], color))
    lines += ["", "Nothing was written."] if dry_run else []
    afterwards(lambda: print("\n".join(lines)), "the package is updated")
    conflicts = [file.path for file in found if file.status == "conflict"]
    if conflicts and not dry_run:
        files = "1 file has" if len(conflicts) == 1 else f"{len(conflicts)} files have"
        say(f"{files} conflicts, marked as git does; edit {', '.join(f'`{each}`' for each in conflicts)}")
    return 1 if conflicts else 0
