"""What launch files give to those that they include, against what these take."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from ...package.launch.file_references import references_in
from ...package.launch.launch_file import Include
from ...package.launch.launch_signature import LaunchSignature
from ...source import Span
from ...suggest import nearest
from .missing_references import LaunchContext

Key = tuple[str, str]
"""The folder of a package, and the source of a launch file in it."""


@dataclass(frozen=True, slots=True)
class ArgumentMismatch:
    span: Span
    file: str
    """The name of the included file."""
    package: str
    argument: str
    lacks: bool
    """Whether it is required and missing; else it is passed and unknown."""
    meant: str | None = None


@dataclass(frozen=True)
class IncludeArguments:
    scope: LaunchContext

    def mismatches(self) -> Iterator[ArgumentMismatch]:
        """Yield the unknown and the missing arguments of includes, as far as the included file is known."""
        for include in self.scope.file.includes if not (self.scope.file.ros1 or self.scope.idle) else ():
            target = self.target(include)
            if target is not None:
                package, signature = target
                yield from self.judge(include, package, signature)

    def target(self, include: Include) -> tuple[str, LaunchSignature] | None:
        folder = self.scope.file.path.rpartition("/")[0]
        named = next(references_in(include.file, folder, "include"), None)
        return self.find(self.scope.package.name, named.package, named.path) if named is not None else None

    def find(self, own: str, package: str, path: str) -> tuple[str, LaunchSignature] | None:
        """Return a launch file by the package that includes it, and by how it is named there."""
        facts = self.scope.workspace.named(package or own)
        for each in facts.launch_files if facts is not None else ():
            if facts is not None and (each.source == path if not package else path in each.places):
                return facts.name, each
        return None

    def judge(self, include: Include, package: str, signature: LaunchSignature) -> Iterator[ArgumentMismatch]:
        name = signature.source.rpartition("/")[2]
        given = {text.literal: text for text, _ in include.arguments}
        takes = self.takes(package, signature, set())
        for argument, text in given.items():
            if argument and takes is not None and argument not in takes:
                free = signature.declared - given.keys()
                yield ArgumentMismatch(text.span, name, package, argument, False, nearest(argument, free))
        for argument in sorted(signature.required - given.keys()):
            if include.complete and None not in given:
                yield ArgumentMismatch(include.span, name, package, argument, True)

    def takes(self, package: str, signature: LaunchSignature, seen: set[Key]) -> frozenset[str] | None:
        """Return all that a file and what it includes declare or use; None where that is unknown."""
        key = (package, signature.source)
        if key in seen:
            return frozenset()
        seen.add(key)
        found = signature.declared | signature.used
        for inner in signature.includes:
            target = self.find(package, *inner)
            more = self.takes(*target, seen) if target is not None else None
            if more is None:
                return None
            found |= more
        return None if signature.open else found
