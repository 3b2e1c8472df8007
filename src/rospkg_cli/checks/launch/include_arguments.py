"""Rule input: arguments that launch files give to included ones, compared with those these declare (LCH015)."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator
from typing import Annotated

from ...light_dataclasses import dataclass, replace
from ...package.launch.file_references import FileReference, first_in
from ...package.launch.launch_file import LaunchFile
from ...package.launch.launch_signature import LaunchSignature
from ...package.launch.launched_parts import Include
from ...ros.known_launch_files import known_arguments
from ...source import Span
from ...suggest import nearest
from ...unreadable import READABLE
from .argument_mismatch import ArgumentMismatch, mistyped, rivals_of
from .launch_context import LaunchContext
from .missing_reference import MissingReference
from .one_cause import CausedPlace, reported_in
from .who_meets import why_unmet


@dataclass(frozen=True)
class IncludeContext:
    scope: LaunchContext
    around: Annotated[tuple[LaunchFile, ...], READABLE] = ()
    """All launch files of the package that can be read."""

    def together(self) -> Iterator[list[CausedPlace[ArgumentMismatch]]]:
        """Yield the places in the package of each mismatch that is reported in this file.

        A missing argument is reported at each include: every one may need another value.
        """
        own = self.scope.file.path
        others = (file for file in self.around if file.path != own)
        files = (self.scope.file, *others) if next(self.mismatches(), None) else ()
        places = [
            CausedPlace(
                (
                    replace(each, span=Span(0, 0)),
                    (file.path, each.span) if each.is_missing and not each.suggestion else "",
                ),
                None if each.is_fault and not why else "info",
                file.path,
                each.span,
                replace(each, why=f", {why}" if why else ""),
            )
            for file in files
            for each in IncludeContext(replace(self.scope, file=file)).mismatches()
            for why in (why_unmet(file, each.span, self.scope.workspace),)
        ]
        yield from reported_in(own, places)

    def mismatches(self) -> Iterator[ArgumentMismatch]:
        """Yield the unknown and the missing arguments of includes, as far as the included file is known."""
        for include in self.scope.file.includes if not (self.scope.file.is_ros1 or self.scope.is_unused_test) else ():
            folder = self.scope.file.path.rpartition("/")[0]
            named = first_in(include.file, folder)
            if named is not None and (target := self.target(named)) is not None:
                package, signature = target
                yield from self.mismatches_of(include, package, signature)
            elif named is not None and self.scope.workspace.named(named.package) is None:
                yield from self.slips(include, named)

    def untaken(self) -> Iterator[Span]:
        """Yield the values of arguments that no included file takes: nothing reads them."""
        unknown = {each.span for each in self.mismatches() if each.is_sure and not each.is_missing}
        for include in self.scope.file.includes if unknown else ():
            yield from (value.span for name, value in include.arguments if name.span in unknown)

    def is_untaken(self, missing: MissingReference) -> bool:
        """Return whether a file is only given as an argument that no included file takes."""
        if missing.use != "file":
            return False
        places, around = (missing.span, *missing.other_spans), tuple(self.untaken())
        return all(any(each.holds(place) for each in around) for place in places)

    def target(self, named: FileReference) -> tuple[str, LaunchSignature] | None:
        known = self.scope.workspace.included_arguments
        return known.find(self.scope.package.name, named.package, named.path)

    def slips(self, include: Include, named: FileReference) -> Iterator[ArgumentMismatch]:
        """Yield what is nearly an argument of a well-known launch file: any other name a later release may take."""
        names = known_arguments(named.package, named.path)
        given = {text.literal: text for text, _ in include.arguments}
        for argument, text in given.items():
            near = mistyped(argument, names - given.keys()) if argument and argument not in names else None
            if argument and near:
                file = posixpath.basename(named.path)
                yield ArgumentMismatch(text.span, file, named.package, argument, False, near)

    def mismatches_of(self, include: Include, package: str, signature: LaunchSignature) -> Iterator[ArgumentMismatch]:
        name = signature.source.rpartition("/")[2]
        given = {text.literal: text for text, _ in include.arguments}
        takes, is_all = self.scope.workspace.included_arguments.names_in(package, signature.source)
        is_open = not include.is_complete or None in given
        lacking = frozenset() if is_open else signature.required - given.keys()
        instead: dict[str, str] = {}
        values = {name.literal: value.literal for name, value in include.arguments}
        for argument, text in given.items():
            if argument and argument not in takes:
                free = signature.declared - given.keys()
                near = nearest(argument, free) if is_all else mistyped(argument, free)
                if near in lacking:
                    instead[near] = argument
                elif is_all or near:
                    rivals = rivals_of(argument, near, free)
                    is_same = (near, values[argument]) in signature.defaults
                    yield ArgumentMismatch(text.span, name, package, argument, False, near, is_all, rivals, is_same)
        for argument in sorted(lacking):
            wrong = instead.get(argument)
            yield ArgumentMismatch(given[wrong].span if wrong else include.span, name, package, argument, True, wrong)
