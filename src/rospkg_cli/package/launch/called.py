"""Calls of the classes of launch against what these take: names, places, and what has to be there."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.python.evaluate.values import Argument, Call
from ...ros.launch_calls import SIGNATURES, Signature
from ...suggest import nearest
from .misuse import Misuse

ELSEWHERE = frozenset(name for signature in SIGNATURES.values() for name in signature.kinds)
"""Arguments that some class of launch has."""

RENAMED = {
    "node_executable": "executable",
    "node_name": "name",
    "node_namespace": "namespace",
    "node_plugin": "plugin",
    "launch_argument_name": "name",
}
"""Old names of arguments, which another rule speaks of."""


def named_arguments(call: Call, signature: Signature) -> Iterator[tuple[str, Argument]]:
    """Yield each argument that is passed with the name that it has in the class."""
    by_place = iter(signature.positional)
    for argument in call.arguments:
        name = argument.name or next(by_place, "")
        if name:
            yield name, argument


def ill_called(call: Call, name: str, signature: Signature) -> Iterator[Misuse]:
    """Yield why Python refuses a call: "unexpected keyword argument", "missing argument", "takes … positional"."""
    known = signature.kinds.keys()
    meant = set()
    for argument in call.arguments:
        if argument.name and argument.name not in known and argument.name not in RENAMED:
            near = nearest(argument.name, known - {"condition"} if argument.name != "conditions" else known)
            if near or argument.name in ELSEWHERE:
                meant.add(near)
                hint = f"; did you mean `{near}`?" if near else ""
                yield Misuse(argument.span, f"`{name}` takes no `{argument.name}`: Python raises TypeError{hint}")
        meant.add(RENAMED.get(argument.name))
    given = [argument for argument in call.arguments if not argument.name]
    most = len(signature.positional)
    if len(given) > most:
        extra = given[most]
        wanted = "by keyword only" if not most else f"only {most} by place, the others by keyword"
        yield Misuse(extra.span, f"`{name}` takes its arguments {wanted}: Python raises TypeError")
        return
    there = {found for found, _ in named_arguments(call, signature)} | meant
    for missing in sorted(signature.required - there):
        if call.rest is None:
            yield Misuse(call.span, f"`{name}` is not given its `{missing}`: Python raises TypeError")
