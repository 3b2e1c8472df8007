"""`rospkg new --update`: what the templates write today, merged with what became of a package."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import Any

from ..disk import read_entry
from ..light_dataclasses import dataclass, field_names, replace
from ..tree import TreeEntry
from . import ScaffoldError
from .answers import Request
from .answers_record import RECORD, AnswersRecord
from .existing_folder import refuse_obstacles
from .extras import NONE, without_none
from .line_digests import digests
from .merge_lines import merge_lines
from .renamed_record import RenamedRecord
from .render import RenderedFile, inside

ADDED = ("nodes", "plugins", "depends", "msgs", "srvs", "actions", "extras")
"""What is added to the answers that were given before; everything else takes their place."""


@dataclass(frozen=True)
class UpdatedFile:
    path: str
    status: str
    """`created`, `updated`, `merged`, `conflict`, `identical`, `kept`, `removed` or `skipped`."""
    before: TreeEntry | None = None
    after: TreeEntry | None = None
    about: str = ""

    @property
    def changes(self) -> bool:
        return self.status in ("created", "updated", "merged", "conflict", "removed")


def answered_anew(record: AnswersRecord, name: str, typed: Request) -> Request:
    """Return the answers of a record with what was typed now; raises ScaffoldError for another type or template.

    `name` is the package's name today. A node is replaced by one of the same name.
    """
    before = replace(record.request, name=name)
    if typed.template not in (Request.template, before.template):
        raise ScaffoldError(f"--update can't make another type of a package; it is `{before.template}`")
    if before.own_template and not typed.own_template:
        raise ScaffoldError(
            f"it was written by a template of one's own; name it, if you trust it: --template {before.own_template}"
        )
    default, values = Request(""), dict[str, Any]()
    for field in field_names(typed):
        value = getattr(typed, field)
        if field in ("name", "template") or value == getattr(default, field):
            continue
        values[field] = joined(getattr(before, field), value) if field in ADDED else value
    if NONE in typed.extras:
        values["extras"] = without_none(typed.extras)
    if typed.parameters and typed.params:
        values["params"] = True  # a form was named, and with it the file of values
    return replace(before, **values)


def joined(before: Sequence[str], typed: Sequence[str]) -> tuple[str, ...]:
    found = {each.partition(":")[0]: each for each in before}
    return tuple({**found, **{each.partition(":")[0]: each for each in typed}}.values())


def updates(package: Path, record: AnswersRecord, name: str, files: Iterable[RenderedFile]) -> Iterator[UpdatedFile]:
    """Yield what becomes of each file; raises ScaffoldError where a path is no file, or git can't be run.

    `files` are those of today's templates, for the name that the package has today.
    """
    now = {file.path: file.entry for file in files}
    renamed = RenamedRecord(record, name)
    written, moves = renamed.paths(), renamed.moves(package, now)
    for path in sorted({*now, *written}):
        place = moves.get(path, path)
        refuse_obstacles(package, package / inside(path))
        refuse_obstacles(package, package / inside(place))
        before = entry_at(package / place)
        texts = [each.data if each else b"" for each in (before, now.get(path))]
        lines = renamed.lines(written[path], *texts) if path in written else None
        if path in now:
            yield from moved(updated(path, before, lines, now[path]), place)
        elif lines is not None and (found := no_longer_written(path, before, lines)):
            yield found


def moved(file: UpdatedFile, place: str) -> Iterator[UpdatedFile]:
    """Yield a file that lay at another place until now, and what becomes of that place."""
    if place == file.path or file.status == "skipped":
        yield file
        return
    status = file.status if file.status == "conflict" else "created"
    yield replace(file, status=status, before=None, after=file.after or file.before, about=f"it was `{place}`")
    yield UpdatedFile(place, "removed", file.before)


def updated(path: str, before: TreeEntry | None, written: Sequence[str] | None, new: TreeEntry) -> UpdatedFile:
    """Return what becomes of a file that is still written; `written` is None where it was not before."""
    if before is None:
        if written is None:
            return UpdatedFile(path, "created", None, new)
        return UpdatedFile(path, "skipped", about="you removed it")
    if before.kind == "link" or before.skipped:
        return UpdatedFile(path, "skipped", before, about="it is a link" if before.kind == "link" else before.skipped)
    if before.data == new.data:
        return UpdatedFile(path, "identical", before)
    if path == RECORD:
        written = digests(before.data)  # nobody edits it
    merged = merge_lines(before.data, written or (), new.data)
    if merged is None:
        return UpdatedFile(path, "skipped", before, about="it is no text, and can't be merged")
    if merged.data == before.data:
        return UpdatedFile(path, "kept", before, about="yours; nothing else became of it")
    mode = new.mode if new.is_executable else before.mode
    after = TreeEntry("file", merged.data, mode)
    if merged.conflicts:
        places = "1 place" if merged.conflicts == 1 else f"{merged.conflicts} places"
        return UpdatedFile(path, "conflict", before, after, f"{places} with `<<<<<<<`")
    is_yours = digests(before.data) != tuple(written or ())
    return UpdatedFile(path, "merged" if is_yours else "updated", before, after)


def no_longer_written(path: str, before: TreeEntry | None, written: Sequence[str]) -> UpdatedFile | None:
    """Return what becomes of a file that was written and would not be today; None where it is gone."""
    if before is None:
        return None
    if before.kind != "link" and not before.skipped and digests(before.data) == tuple(written):
        return UpdatedFile(path, "removed", before)
    return UpdatedFile(path, "kept", before, about="no longer written; you changed it")


def entry_at(path: Path) -> TreeEntry | None:
    try:
        return read_entry(path)
    except FileNotFoundError:
        return None
    except OSError as error:
        raise ScaffoldError(f"`{path}` can't be read: {error.strerror or error}; nothing was written") from error
