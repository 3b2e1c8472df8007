"""What something around the packages switches off: whether the names of their dependencies exist is not checked."""

from __future__ import annotations

from collections.abc import Iterator

from ...package.run_events import CheckSwitchedOff
from ...package.workspace import Workspace
from ...ros.names import FetchedNames, NameKind
from ...source import Span

NO_INDEX = "no index of names was fetched; `rospkg index update` fetches one"


def switched_off(workspace: Workspace) -> Iterator[CheckSwitchedOff]:
    """Yield an event at the first dependency that nothing here knows, with all of them, and why they are not judged."""
    found: dict[str, tuple[str, Span]] = {}
    for facts in workspace.packages:
        for each in facts.dependencies if facts.folder in workspace.selected else ():
            if each.name and each.name not in found and is_unsure(workspace, each.name):
                found[each.name] = facts.at("package.xml"), each.span
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
