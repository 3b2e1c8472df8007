"""Defaults of launch arguments that are never used, as everything that starts the file gives another value."""

from __future__ import annotations

import posixpath

from .documented_arguments import DOCUMENTED, ConfigurationsAndPages
from .launch_configurations import LaunchConfigurations
from .launch_context import LaunchContext
from .missing_reference import MissingReference, defaults_of, is_within

INCLUDED = "which each launch file gives that includes this one"


def why_given(scope: LaunchContext, missing: MissingReference) -> str:
    """Return why a missing file that is only a default is never looked for; "" where it may be.

    Every documented command gives the argument; where none starts the file, every launch file that includes it does.
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
        return f"where no `{name}:=` is given, {DOCUMENTED}" if pages.is_documented(name) else ""
    including = scope.workspace.launch.included.get(posixpath.basename(scope.file.path), [])
    is_given = bool(including) and all(name in each.defines for each in including)
    return f"where no `{name}:=` is given, {INCLUDED}" if is_given else ""
