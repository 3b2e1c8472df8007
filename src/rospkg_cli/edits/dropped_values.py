"""What is said of a value that a launch file gives and no node takes (PRM007)."""

from __future__ import annotations

from collections.abc import Iterable

from ..checks.params.idle_nodes import level_of
from ..checks.params.launched_names import LaunchedName
from ..checks.params.parameter_group import ParameterGroup
from ..checks.params.unknown_parameters import UnknownParameters
from ..finding import Hit, Related, Severity
from ..package.params.parameter_file import Parameter
from ..source import Span
from .parameter_names import renamed
from .plain_names import only_plain_names

MEANS = "did you mean"


def dropped_value(scope: UnknownParameters, named: LaunchedName) -> Hit:
    """Return the hit of a name in a launch file, or of one that a table knows."""
    more, (softer, why) = " any more" if named.is_removed else "", level_of(named.start)
    owner = scope.given.workspace.named(named.package)
    same = named.same or scope.why_unread([owner], named.intended) or scope.may_read(owner, named.name, named.intended)
    is_mild = bool(more) or softer == "info" or not named.is_certain or bool(same)
    is_mild = is_mild or scope.readers.is_idle(named.path, named.span)
    message = f"`{named.package}` declares no parameter `{named.name}`{more}: the value is dropped{why}{same}"
    hint = scope.hint(owner, named.name, named.intended, named.path) if named.intended else "declare it, or take it out"
    level, others = Severity.INFO if is_mild else None, also(named.path, named.others)
    return Hit(named.path, named.span, f"{message}; {hint}", level, others)


def dropped_in_file(scope: UnknownParameters, group: ParameterGroup, parameter: Parameter, intended: str) -> Hit:
    """Return the hit of a name in a parameter file whose block belongs to a package."""
    (name, last), owner = (each.rpartition(".")[2] for each in (parameter.name, intended)), group.owners[0]
    path, place, hint = group.file.path, parameter.key.span, scope.hint(owner, name, last, group.file.path)
    same = scope.why_harmless(group, parameter, intended)
    dropped = f"`{owner.name}` declares no parameter `{parameter.name}`: the value is dropped{same}"
    level = Severity.INFO if same or scope.readers.is_idle(path, place) else None
    fix = only_plain_names(renamed(group, parameter, intended), last) if hint.startswith(MEANS) else None
    return Hit(path, place, f"{dropped}; {hint}", level, fix=fix)


def also(path: str, spans: Iterable[Span]) -> tuple[Related, ...]:
    return tuple(Related(path, span, "and this one") for span in spans)
