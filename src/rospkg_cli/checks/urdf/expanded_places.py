"""Where a fault of an expanded robot is reported: at the element in its file, or at the call of a macro."""

from __future__ import annotations

import re

from ...package.urdf.expansion.expansion import Node
from ...source import Source, Span
from ..fault import Fault

Found = tuple[str, Fault]
"""A file of the package, and a fault in it."""


def own_place(node: Node, span: Span, name: str, *, again: bool = False) -> tuple[Source, Span] | None:
    """Return where a fault of an element is reported: in a file of this package, or at the macro call that made it.

    An element that is made `again` is reported at the call, and a name that a call gives is reported there.
    """
    calls = [(source, tag_span(source, call.span)) for source, call in node.calls]
    for source, call in node.calls if name != node.source.slice(span) and not again else ():
        given = next((each.value_span for each in call.attributes.values() if each.value == name), None)
        if given is not None and not source.path.startswith("/"):
            return source, given
    places = [*calls[:1], (node.source, span)] if again else [(node.source, span), *reversed(calls)]
    return next(((source, at) for source, at in places if not source.path.startswith("/")), None)


def tag_span(source: Source, call: Span) -> Span:
    match = re.compile(r"<[^\s/>]+").match(source.text, call.start)
    return Span(call.start + 1, match.end()) if match else call
