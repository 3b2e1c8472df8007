"""`rospkg rename`: a package or a node, with what names it in the workspace."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path

from ...change import ChangeError
from ...change.draft import Draft
from ...change.git_state import require_clean_everywhere
from ...package.manifest import Manifest
from ...renaming.names_aside import judge_rename
from ...renaming.node_plan import plan_rename_node
from ...renaming.plan import RenamePlan, plan_rename
from ...scaffold import ScaffoldError
from ...scaffold.names import check_node_name, check_package_name
from .. import UsageError
from ..change.finish import ChangeOptions, finish_judged, guarded_change
from ..change.place import ChangePlace, place_of
from .find_package import named_package
from .tell import left_lines, notes_on


def rename(names: Sequence[str], package: Path, options: ChangeOptions, allow_dirty: bool = False) -> int:
    """Rename a package, or a node of one; return the exit status as `add` does. Raises UsageError."""
    match [*names]:
        case [old, new]:
            return guarded_change(lambda: rename_package(old, new, options, allow_dirty))
        case ["node", old, new]:
            return guarded_change(lambda: rename_node(old, new, package, options, allow_dirty))
        case _:
            raise UsageError(
                "give the old name and the new one: `rospkg rename OLD NEW`, or `rospkg rename node OLD NEW`"
            )


def rename_package(typed: str, new: str, options: ChangeOptions, allow_dirty: bool) -> int:
    place, names = named_package(typed)
    if place.folder not in names:
        raise ChangeError(f"the package.xml of `{place.folder}` can't be read; `rospkg lint` says why")
    old = names[place.folder]
    check_new_name(old, new, names)
    plan = plan_rename(place.session.tree, place.folder, old, new)
    return show_or_write(place, plan, (old, new), options, allow_dirty, notes_on(place, plan, old, new))


def rename_node(old: str, new: str, package: Path, options: ChangeOptions, allow_dirty: bool) -> int:
    place = place_of(package)
    draft = Draft(place.session.tree)
    manifest = draft.package(place.folder).parts(Manifest).only
    try:
        check_node_name(new, manifest.name if manifest else "")
    except ScaffoldError as error:
        raise ChangeError(str(error)) from error
    plan = plan_rename_node(place.session.tree, place.folder, old, new)
    return show_or_write(place, plan, (old, new), options, allow_dirty, [])


def show_or_write(
    place: ChangePlace,
    plan: RenamePlan,
    names: tuple[str, str],
    options: ChangeOptions,
    allow_dirty: bool,
    notes: Iterable[str],
) -> int:
    """Judge a plan that changes the first name to the second, then show or write it, and what is left."""
    if not (allow_dirty or options.dry_run or options.diff):
        require_clean_everywhere(place.root, [*plan.renamed, *edited_before(plan)])
    judged = judge_rename(place.session, plan, *names)
    status = finish_judged(place, plan.draft, judged, options, notes, plan.renamed)
    for line in left_lines(place, plan, names[0]):
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
