"""Whether the check for unknown names of dependencies is switched off by something around the packages."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ...finding import Finding
from ...package.run_events import CheckSwitchedOff
from ...package.workspace import Workspace
from ...ros.names import FetchedNames, NameKind
from ...source import Span

NO_INDEX = "no index of names was fetched; `rospkg index update` fetches one"
JUDGES = frozenset({"DEP001", "DEP203"})
"""The rules that report wrong names even where unknown names are not reported."""


def switched_off(workspace: Workspace, findings: Iterable[Finding] = ()) -> Iterator[CheckSwitchedOff]:
    """Yield an event at the first dependency whose name is unknown here, with all such names, and why none is reported.

    Names that a finding reports all the same are left out.
    """
    reported = {(f"/{each.location.path}", each.location.span) for each in findings if each.code in JUDGES}
    found: dict[str, tuple[str, Span]] = {}
    judged: set[str] = set()
    for facts in workspace.packages:
        for each in facts.dependencies if facts.folder in workspace.selected else ():
            place = facts.at("package.xml"), each.span
            if place in reported:
                judged.add(each.name)
            elif each.name and each.name not in found and is_unsure(workspace, each.name):
                found[each.name] = place
    found = {name: place for name, place in found.items() if name not in judged}
    why = workspace.incomplete or ("" if isinstance(workspace.index, FetchedNames) else NO_INDEX)
    if found and why:
        path, span = next(iter(found.values()))
        yield CheckSwitchedOff(path, span, tuple(found), why)


def is_unsure(workspace: Workspace, name: str) -> bool:
    """Return whether it can't be known that a name exists; an index knows, unless a missing repository may have it."""
    is_known = isinstance(workspace.index, FetchedNames) and workspace.missing_repositories
    if workspace.is_available(name) or (is_known and not workspace.may_lack(name)):
        return False
    return workspace.kind_of(name) is NameKind.CANT_TELL
