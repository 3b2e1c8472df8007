"""How each verb that changes packages ends: shown, or judged by lint and written, all of it or nothing."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterable
from pathlib import Path

from ...change import ChangeError
from ...change.draft import Draft
from ...change.judge import judge, refuse_new
from ...control_characters import visible, visible_lines
from ...current_folder import current_folder
from ...engine.fixing.remove_leftovers import remove_leftovers
from ...engine.fixing.write_all import write_all
from ...engine.run.session import Scope
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


def finish(
    place: ChangePlace, draft: Draft, options: ChangeOptions, notes: Iterable[str] = (), scope: Scope | None = None
) -> int:
    """Judge a draft, then show or write it; return the exit status (1 where --diff shows anything).

    `scope` holds the packages after the change, where they are others. Raises ChangeError where lint would report
    something new, and WriteError.
    """
    unchecked: tuple[str, ...] = ()
    if draft.changes:
        judged = judge(place.session, draft, scope)
        refuse_new(judged.new)
        unchecked = judged.unchecked
    for note in (*notes, *unchecked):
        say(note)
    if options.diff:
        from ..diff import unified

        sys.stdout.writelines(unified(place.session.tree, draft.changes))
        return 1 if draft.changes else 0
    rows = [f"{verb} {visible(relative(place.root / path))}" for verb, path in sorted_changes(draft)]
    if not rows:
        say("nothing is to be done: it is there as it should be")
        return 0
    if options.dry_run:
        print("\n".join((*rows, "\nNothing was written.")))
        return 0
    fence = Fence(place.root, place.located.scope.folders)
    remove_leftovers(place.root / folder for folder in place.located.scope.selected)
    write_all(place.root, place.session.tree, draft.changes, fence)
    afterwards(lambda: print("\n".join(rows)), "the files are written")
    return 0


def sorted_changes(draft: Draft) -> list[tuple[str, str]]:
    """Return a word and a path for each file, by path."""
    created = set(draft.created())
    words = {path: "create" if path in created else "edit" for path in draft.changes}
    words |= {path: "remove" for path, entry in draft.changes.items() if entry is None}
    return [(f"{words[path]:<6}", path) for path in sorted(draft.changes)]


def relative(path: Path) -> str:
    """Return a path as the user would type it from here."""
    return Path(os.path.relpath(path, current_folder())).as_posix()
