"""`rospkg new --family`: the packages of a robot in one go."""

from __future__ import annotations

import sys
from pathlib import Path

from ...report.color import wants_color
from ...scaffold import ScaffoldError
from ...scaffold.answers import Request
from ...scaffold.answers_record import with_record
from ...scaffold.extras import notes_on_extras
from ...scaffold.family import plan_family, write_family
from ...scaffold.family_root import family_root
from ...scaffold.target_folder import hidden_from_colcon
from .. import UsageError
from ..streams import afterwards, say
from .interactive import is_confirmed
from .run import NOTHING, command_lines, defaults, file_lines, finding_text, tree_lines


def new_family(
    request: Request,
    into: Path = Path(),
    dry_run: bool = False,
    color: str = "auto",
    confirm: bool = False,
    record: bool = True,
) -> int:
    """Write all packages into a folder, or show every file; return the exit status. `confirm` asks before it writes,
    `record` keeps the answers in each package.

    Raises UsageError and ConfigError for what can't be done as asked.
    """
    try:
        plans = plan_family(request, into, defaults(into))
        plans = [with_record(plan) for plan in plans] if record else plans
        root = family_root(request, into, plans[0].answers.distro.name)
        number = len(root.files) + sum(len(plan.files) for plan in plans)
        if confirm and not dry_run and not is_confirmed(plans, into, number):
            return 0
        if not dry_run:
            write_family(plans, into, root)
    except ScaffoldError as error:
        raise UsageError(str(error)) from error
    notes = [note for plan in plans for note in (*plan.notes, *(finding_text(finding) for finding in plan.findings))]
    notes += notes_on_extras(request.extras, root.folder.parent)
    for line in dict.fromkeys((*notes, *hidden_from_colcon(into))):
        say(line)
    painted = wants_color(color, sys.stdout)
    trees = [line for plan in plans for line in tree_lines(plan.answers.name, plan.files, painted)]
    trees += tree_lines(str(root.folder), root.files, painted) if root.files else ()
    if dry_run:
        files = [line for plan in plans for line in file_lines(plan.answers.name, plan.files, painted)]
        files += file_lines(str(root.folder), root.files, painted)
        print("\n".join((*trees, *files, NOTHING)))
    else:
        lines = (*trees, *command_lines(plans[-1], into, painted))
        afterwards(lambda: print("\n".join(lines)), "the packages are written")
    return 0
