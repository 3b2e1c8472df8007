"""Parameters under the name that code declares."""

from __future__ import annotations

from ..checks.params.parameter_group import ParameterGroup
from ..checks.params.rcl_types import given_type
from ..finding import Edit, Fix, Safety
from ..package.params.parameter_file import Parameter
from ..source import Span


def renamed(group: ParameterGroup, parameter: Parameter, meant: str) -> Fix | None:
    """Return the fix that writes another name; None where the declared type is another one."""
    last, value = meant.rpartition(".")[2], parameter.value
    wanted = group.type_of(meant)
    given = given_type(value)
    edits = [Edit(group.file.path, parameter.key.span, last)]
    if wanted == f"{given}[]":
        start, end = value.span.start, value.span.end
        edits += [Edit(group.file.path, Span(start, start), "["), Edit(group.file.path, Span(end, end), "]")]
    elif wanted and given != wanted:
        return None
    is_written = parameter.key.text == parameter.name.rpartition(".")[2]
    return Fix(f"write `{last}`", tuple(edits), Safety.UNSAFE) if is_written else None
