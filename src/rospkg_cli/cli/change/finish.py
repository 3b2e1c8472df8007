"""How each verb that changes packages ends: shown, or judged by lint and written, all of it or nothing."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path

from ...change import ChangeError
from ...change.draft import Draft
from ...change.judge import Judgement, judge, refuse_new
from ...change.moved_tree import MovedTree
from ...control_characters import visible, visible_lines
from ...current_folder import current_folder
from ...engine.fixing.move import move_all
from ...engine.fixing.remove_leftovers import remove_leftovers
from ...engine.fixing.write_all import write_all
from ...fence import Fence
from ...light_dataclasses import dataclass
from ..streams import afterwards, say
from .place import ChangePlace


@dataclass(frozen=True)
class ChangeOptions:
    """What is done with a change: written, or only shown."""

    dry_run: bool = False
    """Show which files would change; write nothing."""
    diff: bool = False
    """Show how they would change; write nothing."""


def guarded_change(verb: Callable[[], int]) -> int:
    """Run a verb; print the sentence of a ChangeError and the lines below it, and return 2 for it."""
    try:
        return verb()
    except ChangeError as error:
        say(str(error))
        for line in error.details:
            print(visible_lines(line), file=sys.stderr)
        return 2


def finish(place: ChangePlace, draft: Draft, options: ChangeOptions, notes: Iterable[str] = ()) -> int:
    """Judge a draft, then show or write it; return the exit status (1 where --diff shows anything).

    Raises ChangeError where lint would report something new, and WriteError.
    """
    judged = judge(place.session, draft) if draft.changes else None
    return finish_judged(place, draft, judged, options, notes)


def finish_judged(
    place: ChangePlace,
    draft: Draft,
    judged: Judgement | None,
    options: ChangeOptions,
    notes: Iterable[str] = (),
    renamed: Mapping[str, str] | None = None,
) -> int:
    """Show or write a draft as `finish` does; `renamed` are paths with their new last parts, as in MovedTree."""
    if judged:
        refuse_new(judged.new)
    for note in (*notes, *(judged.unchecked if judged else ())):
        say(note)
    moves = [
        f"rename {visible(relative(place.root / path))} to {name}" for path, name in sorted((renamed or {}).items())
    ]
    if options.diff:
        from ..diff import unified

        print("\n".join(moves), end="\n" * bool(moves))
        sys.stdout.writelines(unified(draft.base, draft.changes))
        return 1 if draft.changes or moves else 0
    rows = [*moves, *(f"{verb} {visible(relative(place.root / path))}" for verb, path in sorted_changes(draft))]
    if not rows:
        say("nothing is to be done: it is there as it should be")
        return 0
    if options.dry_run:
        print("\n".join((*rows, "\nNothing was written.")))
        return 0
    write(place, draft, renamed or {})
    afterwards(lambda: print("\n".join(rows)), "the files are written")
    return 0


def write(place: ChangePlace, draft: Draft, renamed: Mapping[str, str]) -> None:
    """Write all of it, or nothing; raises WriteError."""
    scope = place.located.scope
    remove_leftovers(place.root / folder for folder in scope.selected)
    moved = MovedTree(place.session.tree, renamed).moved
    fence = Fence(place.root, [moved(folder) for folder in scope.folders])
    move_all(place.root, renamed, lambda: write_all(place.root, draft.base, draft.changes, fence))


def sorted_changes(draft: Draft) -> list[tuple[str, str]]:
    """Return a word and a path for each file, by path."""
    created = set(draft.created())
    words = {path: "create" if path in created else "edit" for path in draft.changes}
    words |= {path: "remove" for path, entry in draft.changes.items() if entry is None}
    return [(f"{words[path]:<6}", path) for path in sorted(draft.changes)]


def relative(path: Path) -> str:
    """Return a path as the user would type it from here."""
    return Path(os.path.relpath(path, current_folder())).as_posix()
