"""The record of answers that `rospkg new --update` reads, kept in step with what `add` and `remove` do."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

from ..change.draft import Draft, entry_in
from ..light_dataclasses import dataclass, replace
from ..scaffold import OwnFaultError, ScaffoldError
from ..scaffold.answers import Request
from ..scaffold.answers_record import RECORD, AnswersRecord, record_in, record_text
from ..scaffold.line_digests import digests
from ..scaffold.merge_lines import merge_lines
from ..scaffold.plan import make_plan
from ..scaffold.renamed_record import as_word
from ..scaffold.update import joined
from .dependency import manifest_of
from .wanted import Wanted

Lines = tuple[str, ...]
"""The digests of the lines of a file."""

FIELDS = {
    "node": "nodes", "plugin": "plugins", "msg": "msgs", "srv": "srvs", "action": "actions", "dependency": "depends",
}  # fmt: skip
"""The answers that name what was added. Launch files, parameters and tests have none, and stay the user's own."""

INTERFACES = ("msgs", "srvs", "actions")

CMAKE = "CMakeLists.txt"


def keep_record(draft: Draft, place: Path, folder: str, wanted: Wanted, adds: bool) -> None:
    """Put the record into a draft as it is after a change: with other answers, and with the lines that were written.

    It stays as it is where `rospkg new` would not write such a package: then these lines count as the user's.
    `place` is the folder around the package.
    """
    path = f"{folder}/{RECORD}".lstrip("/")
    entry = draft.entry(path)
    if not draft.changes or entry is None or entry.kind == "link" or entry.skipped or wanted.what not in FIELDS:
        return
    name = manifest_of(draft.package(folder)).name
    try:
        record = record_in(entry.data, path)
        request = answered(record.request, wanted, adds)
        if (
            request is None
            or request.own_template
            or (adds and request.parameters == "generate" and wanted.what == "node")
        ):
            return  # `add` writes nodes that declare their parameters themselves
        planned = make_plan(replace(request, name=name), place, {}).files
        old = Renamed(name, record.request.name or name)
        made = {old.text(file.path): digests(old.data(file.entry.data)) for file in planned}
        is_exact = wanted.what == "dependency" and adds
        if is_exact and not is_found_by_cmake(draft, folder, record, made, old):
            return
        lines = lines_after(record, changed_files(draft, folder, old), made, is_exact)
    except (ScaffoldError, OwnFaultError, UnicodeError):
        return
    if lines is not None:
        draft.put({path: replace(entry, data=record_text(request, lines).encode())})


def answered(before: Request, wanted: Wanted, adds: bool) -> Request | None:
    """Return the answers with more or fewer names; None where these were not asked for, or none would be left."""
    field = FIELDS[wanted.what]
    given: tuple[str, ...] = getattr(before, field)
    gone = {each.partition(":")[0] for each in wanted.names}
    values = joined(given, wanted.names) if adds else tuple(e for e in given if e.partition(":")[0] not in gone)
    answers: dict[str, Any] = {field: values}
    after = replace(before, **answers)
    return None if values == given or asks_for_the_usual(after, field) else after


def asks_for_the_usual(request: Request, field: str) -> bool:
    """Return whether nothing of a kind is asked for, which means the node, plugin or message that is always there."""
    kinds = INTERFACES if field in INTERFACES else (field,)
    return field != "depends" and not any(getattr(request, each) for each in kinds)


@dataclass(frozen=True)
class Renamed:
    """The name of a package today, and that of its record: lines are compared as they read under the latter."""

    today: str
    before: str

    def text(self, text: str) -> str:
        return text if self.today == self.before else as_word(self.today).sub(self.before, text)

    def data(self, data: bytes) -> bytes:
        return self.text(data.decode("utf-8", "surrogateescape")).encode("utf-8", "surrogateescape")


def is_found_by_cmake(
    draft: Draft, folder: str, record: AnswersRecord, planned: Mapping[str, Lines], renamed: Renamed
) -> bool:
    """Return whether CMakeLists.txt has the lines that `new` would write there for a dependency more.

    `add` looks for it only where a source includes it; an update would put the lines into the way of later ones.
    """
    entry = draft.entry(f"{folder}/{CMAKE}".lstrip("/"))
    more = {*planned.get(CMAKE, ())} - {*record.lines.get(CMAKE, ())}
    return entry is None or more <= {*digests(renamed.data(entry.data))}


def changed_files(draft: Draft, folder: str, renamed: Renamed) -> Iterator[tuple[str, Lines | None, Lines | None]]:
    """Yield the path of each file in the package that changed, and the digests of its lines before and after."""
    for path, after in draft.changes.items():
        inner = path.removeprefix(f"{folder}/" if folder else "")
        before, now = (
            digests(renamed.data(entry.data)) if entry else None for entry in (entry_in(draft.base, path), after)
        )
        yield renamed.text(inner), before, now


def lines_after(
    record: AnswersRecord,
    changes: Iterable[tuple[str, Lines | None, Lines | None]],
    planned: Mapping[str, Lines],
    is_exact: bool,
) -> dict[str, Lines] | None:
    """Return the lines of the record with what changed in them; None where `new` would write other files.

    With `is_exact` also where it would write other lines. Raises ScaffoldError where git can't be run.
    """
    lines = dict(record.lines)
    for path, before, now in changes:
        if before is None:
            if path not in planned:
                return None
            lines[path] = planned[path]
        elif now is None:
            lines.pop(path, None)
        elif path in lines:
            if is_exact and not {*now} - {*before} <= {*planned.get(path, ())}:
                return None
            merged = merge_lines(joined_lines(lines[path]), digests(joined_lines(before)), joined_lines(now))
            if merged and not merged.conflicts:
                lines[path] = tuple(merged.data.decode().split())
    return lines


def joined_lines(lines: Lines) -> bytes:
    return "\n".join(lines).encode()
