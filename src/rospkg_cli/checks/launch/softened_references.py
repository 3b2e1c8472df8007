"""How grave it is that a file is missing which a launch file names: who opens it, and when (LCH003)."""

from __future__ import annotations

from ..fault import Level
from .idle_actions import level_at
from .include_arguments import IncludeContext
from .missing_references import LaunchContext, MissingReference
from .relative_parameter_files import has_others_beside, is_for_nodes
from .undeclared_files import undeclared_for


def softened(scope: LaunchContext, each: MissingReference) -> tuple[Level | None, str]:
    """Return the level that a missing file has at most, and why; None where nothing softens it."""
    softer, why = level_at(scope.file, each.span) if each.use != "caught" else ("info", "")
    if not softer and scope.is_unread(each):
        softer, why = "info", "but nothing uses the argument"
    if not softer and scope.is_overwritten(each):
        softer, why = "info", "but the launch file gives the argument another value"
    if not softer and IncludeContext(scope).is_untaken(each):
        softer, why = "info", "but the included file takes no such argument"
    if softer != "info" and (unasked := undeclared_for(scope, each)):
        softer, why = "info", unasked
    if softer != "info" and is_for_nodes(scope, each) and has_others_beside(scope, each):
        softer = "info"
    if not softer and not scope.is_installed:
        softer, why = "warning", "where it is started from the source: it is not installed"
    return softer, why
