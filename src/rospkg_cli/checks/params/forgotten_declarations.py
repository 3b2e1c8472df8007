"""Parameters that the code of a node gets, and that no code declares under any similar name."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from ...light_dataclasses import dataclass, replace
from .forgotten_in_python import ForgottenInPython
from .parameter_reads import ParameterReads
from .unknown_read import UnknownRead


@dataclass(frozen=True)
class ForgottenDeclarations:
    """Reads of names that occur nowhere in the code of a package but where it gets them."""

    reads: ParameterReads
    python: ForgottenInPython

    def all(self, reported: Collection[tuple[str, int]]) -> Iterator[UnknownRead]:
        """Yield the first read of such a name in each file, with the other names; without places in `reported`.

        Yield nothing where code may declare parameters whose names it does not hold.
        """
        found: dict[tuple[str, bool, bool], list[UnknownRead]] = {}
        for each in (*self.in_cpp(), *self.python.all()):
            if (each.path, each.span.start) not in reported:
                found.setdefault((each.path, each.throws, each.is_dropped), []).append(each)
        for first, *others in found.values():
            yield replace(first, more=tuple((each.name, each.span) for each in others))

    def in_cpp(self) -> Iterator[UnknownRead]:
        if self.reads.cpp:
            from .forgotten_in_cpp import ForgottenInCpp  # what packages in Python don't need

            yield from ForgottenInCpp(self.reads).all()
