"""The workspace, how it was found, its packages, and what keeps checks from running in it."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from ...current_folder import absolute
from ...engine.discovery.hidden_packages import hidden_packages
from ...engine.discovery.locate import Located, mark_of_workspace, workspace_of
from ...report.summary import counted
from .topic import Topic

MAX_SHOWN = 3
"""Hidden packages that are named."""


def workspace(paths: Sequence[Path], located: Located) -> Topic:
    """Return the root of the workspace, and what it was known by."""
    selected = [located.root / folder for folder in located.scope.selected]
    found = workspace_of(selected)
    if found is None:
        why = "no workspace around; its neighbours in the same folder are known" if selected else "no package here"
        return Topic("workspace", (why,), {"root": None, "mark": None})
    mark = mark_of_workspace(found, selected[0])
    return Topic("workspace", (f"{found}, known by `{mark}`",), {"root": str(found), "mark": mark})


def packages(paths: Sequence[Path], located: Located) -> Topic:
    """Return how many packages are linted, of how many that are known, and which are hidden and by what."""
    scope = located.scope
    hidden = hidden_packages(map(absolute, paths))
    data = {
        "linted": len(scope.selected),
        "known": len(scope.folders),
        "hidden": [{"path": str(package), "by": str(by)} for package, by in hidden],
    }
    lines = [f"{len(scope.selected)} linted, {len(scope.folders)} in the workspace"]
    lines += [f"hidden: {package}, by {by}" for package, by in hidden[:MAX_SHOWN]]
    if len(hidden) > MAX_SHOWN:
        lines.append(f"and {counted(len(hidden) - MAX_SHOWN, 'more hidden package')}; --format json lists them")
    if scope.selected:
        return Topic("packages", tuple(lines), data)
    why = f"nothing is linted: {located.hidden}" if located.hidden else "nothing is linted: there is no package.xml"
    return Topic("packages", (why,), data, "give the path of a package or of a workspace", is_wrong=True)


def switched_off(located: Located, has_index: bool) -> Topic:
    """Return what something around the packages keeps from being checked."""
    reasons = [located.scope.incomplete] if located.scope.incomplete else []
    reasons += [] if has_index else ["no index of names was fetched"]
    lines = tuple(f"unknown package names: {why}" for why in reasons)
    return Topic("not checked", lines or ("nothing is left out",), {"unknown_names": reasons})
