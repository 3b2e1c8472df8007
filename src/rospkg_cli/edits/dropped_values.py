"""What is said of a value that a launch file gives and no node takes (PRM007)."""

from __future__ import annotations

from collections.abc import Iterable

from ..checks.params.idle_nodes import level_of
from ..checks.params.launched_names import LaunchedName
from ..checks.params.unknown_parameters import UnknownParameters
from ..finding import Hit, Related, Severity
from ..source import Span


def dropped_value(scope: UnknownParameters, named: LaunchedName) -> Hit:
    """Return the hit of a name in a launch file, or of one that a table knows."""
    more, (softer, why) = " any more" if named.is_removed else "", level_of(named.start)
    owner = scope.given.workspace.named(named.package)
    same = named.same or scope.why_unread([owner], named.meant) or scope.may_read(owner, named.name, named.meant)
    is_mild = bool(more) or softer == "info" or not named.is_certain or bool(same)
    is_mild = is_mild or scope.readers.is_idle(named.path, named.span)
    message = f"`{named.package}` declares no parameter `{named.name}`{more}: the value is dropped{why}{same}"
    hint = f"did you mean `{named.meant}`?" if named.meant else "declare it, or take it out"
    level, others = Severity.INFO if is_mild else None, also(named.path, named.others)
    return Hit(named.path, named.span, f"{message}; {hint}", level, others)


def also(path: str, spans: Iterable[Span]) -> tuple[Related, ...]:
    return tuple(Related(path, span, "and this one") for span in spans)
