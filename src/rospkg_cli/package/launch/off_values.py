"""Values of a launch file that only parts of it read which are off by default: the share of a package."""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator

from ...languages.python.file import PythonFile
from ...languages.python.nodes import nodes_of_kind
from ...languages.python.unread_values import bound_values, only_read_in
from .default_conditions import OffByDefault


def with_values(file: PythonFile | None, off: Iterable[OffByDefault]) -> Iterator[OffByDefault]:
    """Yield parts that are off by default, and the values that only they read, each with what turns on a reader.

    Python makes these values in any case; launch visits a substitution or an action only where it is read.
    """
    parts = list(off)
    yield from parts
    if file is None or not parts:
        return
    names = {file.span(value): names[0] for names, value in bound_values(file)}
    loads = [each for each in nodes_of_kind(file.tree, ast.Name) if isinstance(each.ctx, ast.Load)]
    for span in only_read_in(file, [each.span for each in parts]):  # behind the values that read it themselves
        places = [file.span(each) for each in loads if each.id == names[span]]
        reader = next((each for each in parts if any(each.span.contains(place) for place in places)), None)
        if reader is not None:
            parts.append(OffByDefault(span, reader.argument))
            yield parts[-1]
