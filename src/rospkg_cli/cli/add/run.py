"""`rospkg add` and `rospkg remove`: to and from a package that exists."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

from ...addition.dependency import AddedDependency, manifest_of
from ...addition.kept_record import keep_record
from ...addition.named import is_needed
from ...addition.node import names_message
from ...addition.part import Part, put_in, take_out
from ...addition.wanted import Wanted, parts_to_add, parts_to_remove
from ...change import ChangeError
from ...change.draft import Draft
from ...change.git_state import require_clean
from ...scaffold import ScaffoldError
from ...scaffold.workspace import WorkspacePackages, workspace_packages
from ..change.finish import ChangeOptions, finish, guarded_change
from ..change.place import ChangePlace, place_of


def add(wanted: Wanted, path: Path, options: ChangeOptions) -> int:
    """Add to the package at a path; return the exit status: 2 for what can't be done, with nothing written."""
    return guarded_change(lambda: add_to(place_of(path), wanted, options))


def add_to(place: ChangePlace, wanted: Wanted, options: ChangeOptions) -> int:
    draft = Draft(place.session.tree)
    try:
        for name in wanted.names:
            parts = parts_to_add(draft.package(place.folder), wanted, name, around(place, name))
            put_in(draft, place.folder, parts)
        keep_record(draft, (place.root / place.folder).parent, place.folder, wanted, adds=True)
    except ScaffoldError as error:
        raise ChangeError(str(error)) from error
    return finish(place, draft, options)


def remove(wanted: Wanted, path: Path, options: ChangeOptions, allow_dirty: bool = False) -> int:
    """Remove from the package at a path what `add` put there; return the exit status as `add` does.

    Where `add` would not bring it back as it is, git must be able to, or `allow_dirty` is given.
    """
    return guarded_change(lambda: remove_from(place_of(path), wanted, options, allow_dirty))


def remove_from(place: ChangePlace, wanted: Wanted, options: ChangeOptions, allow_dirty: bool) -> int:
    draft = Draft(place.session.tree)
    exact, every = not wanted.force, list[Part]()
    try:
        for name in wanted.names:
            there = workspace_packages((place.root / place.folder).parent)  # what its interfaces look like
            parts = parts_to_remove(draft.package(place.folder), wanted, name, there)
            exact &= take_out(draft, place.folder, parts)
            every += parts
        keep_record(draft, (place.root / place.folder).parent, place.folder, wanted, adds=False)
    except ScaffoldError as error:
        raise ChangeError(str(error)) from error
    if not (exact or allow_dirty or options.dry_run or options.diff):
        require_clean(place.root, draft.changes)
    return finish(place, draft, options, staying(draft, place, every))


def around(place: ChangePlace, name: str) -> WorkspacePackages:
    """Return the packages around, where a name needs them: that of a node with a message."""
    return workspace_packages((place.root / place.folder).parent) if names_message(name) else WorkspacePackages()


def staying(draft: Draft, place: ChangePlace, parts: Iterable[Part]) -> Iterator[str]:
    """Yield a sentence on dependencies that go, and one on those that stay because something else needs them."""
    before = manifest_of(Draft(draft.base).package(place.folder))
    manifest = manifest_of(draft.package(place.folder))
    names = sorted({each.name for each in parts if isinstance(each, AddedDependency) and before.depends_on(each.name)})
    stay = [name for name in names if manifest.depends_on(name)]
    gone = [name for name in names if name not in stay]
    if gone:
        yield f"{enumerated(gone)} {'goes' if len(gone) == 1 else 'go'} from package.xml: nothing else names it"
    used = [name for name in stay if is_needed(draft.package(place.folder), name)]
    for some, why in ((used, "other files need it"), ([n for n in stay if n not in used], "under another tag")):
        if some:
            yield f"{enumerated(some)} {'stays' if len(some) == 1 else 'stay'} in package.xml: {why}"


def enumerated(names: Sequence[str]) -> str:
    return ", ".join(f"`{name}`" for name in names)
