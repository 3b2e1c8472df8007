"""`rospkg new`: write a package that builds, runs, passes its own tests and our linter."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Mapping
from pathlib import Path

from ...config.file import find_config, user_config
from ...control_characters import visible, visible_lines, without_workflow_commands
from ...finding import Finding
from ...report.color import paint, wants_color
from ...scaffold import ScaffoldError
from ...scaffold.answers import Request
from ...scaffold.answers_record import RECORD, with_record
from ...scaffold.existing_folder import FolderDifference, compare
from ...scaffold.file_tree import LINES, TreeRow, in_ascii, tree_rows
from ...scaffold.names import check_package_name
from ...scaffold.plan import Plan, make_plan
from ...scaffold.render import RenderedFile
from ...scaffold.target_folder import check_target, hidden_from_colcon, workspace_of
from ...scaffold.template import WORKSPACE
from ...scaffold.write import refuse_existing
from .. import UsageError
from ..streams import afterwards, can_encode, say
from .file_status import folder_status, status_lines
from .place import is_empty
from .write_package import show_difference, write_plan

NOTHING = "\nNothing was written."


def new(
    request: Request,
    into: Path = Path(),
    dry_run: bool = False,
    color: str = "auto",
    existing: str = "",
    diff: bool = False,
    confirm: bool = False,
    record: bool = True,
) -> int:
    """Write the package into a folder, or show every file; return the exit status.

    `existing` is `force` or `skip` where there may be such a folder; `diff` shows what would change there.
    `confirm` asks before anything is written; `record` says whether the answers are kept in the package.

    Raises UsageError and ConfigError for what can't be done as asked.
    """
    target = into / request.name
    try:
        check_name(request)
        existing = existing or ("skip" if is_empty(target) else "")
        check_target(into, target, bool(existing) or diff or (target.is_dir() and not target.is_symlink()))
        plan = planned(request, into, record)
        there = compare(target, plan.files)
        if not (existing or diff):
            refuse_folder(target, there)
        if diff:
            return show_difference(plan, there, existing)
        if confirm and not dry_run and not is_wanted(plan, there, into, existing):
            return 0
        done = "" if dry_run else write_plan(target, plan, there, existing)
    except ScaffoldError as error:
        raise UsageError(str(error)) from error
    for line in (
        *filter(None, [done]),
        *plan.notes,
        *hidden_from_colcon(into),
        *(finding_text(finding) for finding in plan.findings),
    ):
        say(line)
    painted = wants_color(color, sys.stdout)
    had_files = bool(there.same or there.other)
    tree = (
        status_lines(folder_status(there, existing), painted)
        if had_files
        else tree_lines(request.name, plan.files, painted)
    )
    if dry_run:
        print("\n".join((*tree, *file_lines(request.name, plan.files, painted), NOTHING)))
    else:
        lines = (*tree, *command_lines(plan, into, painted))
        afterwards(lambda: print("\n".join(lines)), "the package is written")
    return 0


def check_name(request: Request) -> None:
    if request.template != WORKSPACE:
        check_package_name(request.name)


def planned(request: Request, into: Path, record: bool) -> Plan:
    if request.template == WORKSPACE:
        from ...scaffold.workspace_plan import plan_workspace

        plan = plan_workspace(request, into, defaults(into))
    else:
        plan = make_plan(request, into, defaults(into))
    return with_record(plan) if record else plan


def refuse_folder(target: Path, there: FolderDifference) -> None:
    """Raise ScaffoldError where something has the name already, and show what would become of its files."""
    if there.same or there.other:
        for line in status_lines(folder_status(there, ""), wants_color("auto", sys.stderr)):
            print(line, file=sys.stderr)
    refuse_existing(target, f", `rospkg new --update {target}` merges" if (target / RECORD).is_file() else "")


def is_wanted(plan: Plan, there: FolderDifference, into: Path, existing: str) -> bool:
    from .interactive import is_confirmed

    return is_confirmed([plan], into, len(there.missing) + (len(there.other) if existing == "force" else 0))


def defaults(into: Path) -> Mapping[str, str]:
    """Return what the config of the place says under `new`, and the user's own config where that says nothing."""
    return {**user_config().new, **find_config(into).new}


def finding_text(finding: Finding) -> str:
    return f"{finding.location.path}:{finding.location.line}: {finding.message} ({finding.code})"


def tree_lines(name: str, files: Iterable[RenderedFile], color: bool) -> Iterable[str]:
    rows = tree_rows(visible(name), {visible(file.path): visible(file.about) for file in files})
    rows = rows if can_encode(sys.stdout, LINES) else in_ascii(rows)
    width = max(len(row.drawn) for row in rows)
    for row in rows:
        yield (
            f"{row.drawn:<{width}}   {paint(row.about, 'dim', color)}".rstrip()
            if row.about
            else bold_folder(row, color)
        )


def bold_folder(row: TreeRow, color: bool) -> str:
    return row.drawn.replace(row.name, paint(row.name, "bold", color)) if row.name.endswith("/") else row.drawn


def command_lines(plan: Plan, into: Path, color: bool) -> Iterable[str]:
    workspace = (into / plan.answers.name).absolute() if plan.template.name == WORKSPACE else workspace_of(into)
    here = workspace == Path.cwd()
    yield "\nNext:" if here else f"\nNext, in {visible(str(workspace))}:"
    for command in plan.commands:
        yield f"  {paint(visible(command), 'cyan', color)}"


def file_lines(name: str, files: Iterable[RenderedFile], color: bool) -> Iterable[str]:
    line = "──" if can_encode(sys.stdout, LINES) else "--"
    for file in files:
        text = without_workflow_commands(visible_lines(file.entry.text.text))
        yield paint(f"\n{line} {visible(name)}/{visible(file.path)}{'' if text else ' (empty)'}", "bold", color)
        if text:
            yield text.removesuffix("\n")
