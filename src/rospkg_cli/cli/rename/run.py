"""`rospkg rename OLD NEW`: a package, with what names it in the workspace."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from ...change import ChangeError
from ...change.git_state import require_clean_everywhere
from ...renaming.names_aside import judge_rename
from ...renaming.plan import RenamePlan, plan_rename
from ...scaffold import ScaffoldError
from ...scaffold.names import check_package_name
from .. import UsageError
from ..change.finish import ChangeOptions, finish_judged, guarded_change
from .find_package import named_package
from .tell import left_lines, notes_on


def rename(names: Sequence[str], options: ChangeOptions, allow_dirty: bool = False) -> int:
    """Rename OLD to NEW; return the exit status as `add` does. Raises UsageError."""
    match [*names]:
        case [old, new]:
            return guarded_change(lambda: rename_package(old, new, options, allow_dirty))
        case _:
            raise UsageError("give the old name and the new one: `rospkg rename OLD NEW`")


def rename_package(typed: str, new: str, options: ChangeOptions, allow_dirty: bool) -> int:
    place, names = named_package(typed)
    if place.folder not in names:
        raise ChangeError(f"the package.xml of `{place.folder}` can't be read; `rospkg lint` says why")
    old = names[place.folder]
    check_new_name(old, new, names)
    plan = plan_rename(place.session.tree, place.folder, old, new)
    if not (allow_dirty or options.dry_run or options.diff):
        require_clean_everywhere(place.root, [*plan.renamed, *edited_before(plan)])
    judged = judge_rename(place.session, plan, old, new)
    status = finish_judged(place, plan.draft, judged, options, notes_on(place, plan, old, new), plan.renamed)
    for line in left_lines(place, plan, old):
        print(line)
    return status


def edited_before(plan: RenamePlan) -> Iterator[str]:
    """Yield the files that are edited, as they are called now."""
    return (path for path in sorted(plan.mentions) if plan.moved(path) in plan.draft.changes)


def check_new_name(old: str, new: str, names: Mapping[str, str]) -> None:
    """Raise ChangeError for a name that the package can't get; `names` are those of the packages by folder."""
    if old == new:
        raise ChangeError(f"the package is called `{old}` already")
    try:
        check_package_name(new)
    except ScaffoldError as error:
        raise ChangeError(str(error)) from error
    if taken := [folder for folder, name in names.items() if name == new]:
        raise ChangeError(f"`{new}` is the name of the package in `{taken[0]}`; choose another name")
