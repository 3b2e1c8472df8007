"""Defaults of launch arguments that nobody gets, as everything that starts the file gives another value."""

from __future__ import annotations

import posixpath

from .missing_references import LaunchContext, MissingReference, defaults_of, is_within
from .told_arguments import TOLD, ConfigurationsAndPages
from .unset_configurations import LaunchConfigurations

INCLUDED = "which each launch file gives that includes this one"


def why_given(scope: LaunchContext, missing: MissingReference) -> str:
    """Return why nobody meets a missing file that is only a default; "" where somebody may.

    Each command that pages and comments tell gives the argument; where none starts the file, each that includes it.
    """
    if missing.use != "default":
        return ""
    names = [
        each.name.literal
        for each in scope.file.arguments
        if each.name.literal and is_within(missing, tuple(defaults_of([each])))
    ]
    if len(names) != 1:
        return ""
    name = names[0]
    pages = ConfigurationsAndPages(LaunchConfigurations(scope.workspace, scope.file), scope.files, scope.package)
    if pages.commands:
        return f"where no `{name}:=` is given, {TOLD}" if pages.is_told(name) else ""
    including = scope.workspace.launch.included.get(posixpath.basename(scope.file.path), [])
    is_given = bool(including) and all(name in each.defines for each in including)
    return f"where no `{name}:=` is given, {INCLUDED}" if is_given else ""
