"""What is said of a rename: what follows the name, and which places keep the old one."""

from __future__ import annotations

import shlex
from collections.abc import Iterator
from pathlib import Path

from ...control_characters import visible
from ...current_folder import current_folder
from ...fence import is_within
from ...renaming.plan import RenamePlan
from ...report.summary import counted
from ..change.finish import relative
from ..change.place import ChangePlace

MAX_SHOWN = 30
"""Places that are listed; a search finds the others."""
MAX_WIDTH = 120


def notes_on(place: ChangePlace, plan: RenamePlan, old: str, new: str) -> Iterator[str]:
    """Yield a sentence on each thing that a user should know before and after."""
    package = plan.package
    folder = place.root / package.folder
    if package.folder not in plan.renamed and folder.name == old:
        above = Path(relative(folder.parent))
        move = shlex.join(["mv", str(above / old), str(above / new)])
        yield f"the folder `{old}` keeps its name: no workspace is around it; to rename it too: {move}"
    elif package.folder not in plan.renamed:
        yield f"the folder `{folder.name}` keeps its name: it is not that of the package"
    if package.has_executable:
        yield f"the executable `{old}` is called `{new}` too: `ros2 run {new} {new}`"
    if package.has_library:
        yield f"the library `{old}` is called `{new}` too"
    if any(old in path for path in plan.mentions if path.endswith(".repos")):
        yield "lists of repositories (.repos) are left as they are"
    if plan.has_new_before:
        yield f"`{new}` stood in files of the workspace before: renaming back would change these places too"
    built = [name for name in ("build", "install") if (place.root / name / old).exists()]
    if built:
        folders = " and ".join(f"`{relative(place.root / name / old)}`" for name in built)
        yield f"{folders} are left of earlier builds: remove them, or the old package is still found"
    here = str(current_folder())
    if any(is_within(here, str(place.root / path)) for path in plan.renamed):
        yield "the current folder gets another name: change to it by its new path"


def left_lines(place: ChangePlace, plan: RenamePlan, old: str) -> Iterator[str]:
    """Yield the places that still have the old name, and what they are."""
    if not plan.left:
        return
    lines = counted(len(plan.left), "line")
    yield f"\n{lines} with `{old}` left: prose, comments, namespaces, and names of other things than the package"
    for each in plan.left[:MAX_SHOWN]:
        yield f"  {visible(relative(place.root / each.path))}:{each.line}: {visible(each.text)[:MAX_WIDTH]}"
    if len(plan.left) > MAX_SHOWN:
        yield f"  … and {len(plan.left) - MAX_SHOWN} more: git grep -nw {old}"
