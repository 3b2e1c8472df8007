"""What something around the packages switches off: whether the names of their dependencies exist is not checked."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ...finding import Finding
from ...package.run_events import CheckSwitchedOff
from ...package.workspace import Workspace
from ...ros.names import FetchedNames, NameKind
from ...source import Span

NO_INDEX = "no index of names was fetched; `rospkg index update` fetches one"
JUDGES = frozenset({"DEP001", "DEP203"})
"""The rules that tell that a name is wrong even where unknown ones are not judged."""


def switched_off(workspace: Workspace, findings: Iterable[Finding] = ()) -> Iterator[CheckSwitchedOff]:
    """Yield an event at the first dependency that nothing here knows, with all of them, and why they are not judged.

    Names that a finding judges all the same are left out.
    """
    told = {(f"/{each.location.path}", each.location.span) for each in findings if each.code in JUDGES}
    found: dict[str, tuple[str, Span]] = {}
    judged: set[str] = set()
    for facts in workspace.packages:
        for each in facts.dependencies if facts.folder in workspace.selected else ():
            place = facts.at("package.xml"), each.span
            if place in told:
                judged.add(each.name)
            elif each.name and each.name not in found and is_unsure(workspace, each.name):
                found[each.name] = place
    found = {name: place for name, place in found.items() if name not in judged}
    why = workspace.incomplete or ("" if isinstance(workspace.index, FetchedNames) else NO_INDEX)
    if found and why:
        path, span = next(iter(found.values()))
        yield CheckSwitchedOff(path, span, tuple(found), why)


def is_unsure(workspace: Workspace, name: str) -> bool:
    """Return whether nothing is said of a name: an index tells it, unless a missing repository is called like it."""
    is_told = isinstance(workspace.index, FetchedNames) and workspace.missing_repositories
    if workspace.is_available(name) or (is_told and not workspace.may_lack(name)):
        return False
    return workspace.kind_of(name) is NameKind.CANT_TELL
