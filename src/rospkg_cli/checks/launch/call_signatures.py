"""Calls of launch classes that Python refuses: unknown keywords, missing and surplus arguments (LCH014)."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.python.evaluate.values import Call
from ...package.launch.launch_classes import named_arguments
from ...ros.launch_calls import SIGNATURES, Signature
from ...suggest import nearest
from ..fault import Fault
from .removed_arguments import renamed

ANY_ARGUMENT = frozenset(name for signature in SIGNATURES.values() for name in signature.kinds)
"""Arguments that some class of launch has."""


def signature_faults(call: Call, name: str, signature: Signature) -> Iterator[Fault]:
    """Yield why Python refuses a call: unexpected keyword, missing argument, too many positional arguments."""
    known, old = signature.kinds.keys(), renamed(name)
    intended = set()
    for argument in call.arguments:
        if argument.name and argument.name not in known and argument.name not in old:
            near = nearest(argument.name, known - {"condition"} if argument.name != "conditions" else known)
            if near or argument.name in ANY_ARGUMENT:
                intended.add(near)
                hint = f"; did you mean `{near}`?" if near else ""
                yield Fault(argument.span, f"`{name}` takes no `{argument.name}`: Python raises TypeError{hint}")
        intended.add(old.get(argument.name))
    positional = [argument for argument in call.arguments if not argument.name]
    most = len(signature.positional)
    if len(positional) > most:
        limit = f"at most {most} positional argument{'s' * (most != 1)}" if most else "keyword arguments only"
        yield Fault(positional[most].span, f"`{name}` takes {limit}: Python raises TypeError")
        return
    present = {found for found, _ in named_arguments(call, signature)} | intended
    for missing in sorted(signature.required - present):
        if call.rest is None:
            yield Fault(call.span, f"`{name}` is called without its required `{missing}`: Python raises TypeError")
