"""What launch files give to those that they include, against what these take."""

from __future__ import annotations

from collections.abc import Iterator

from ...light_dataclasses import dataclass
from ...package.launch.file_references import references_in
from ...package.launch.launch_file import Include
from ...package.launch.launch_signature import LaunchSignature
from ...source import Span
from ...suggest import nearest
from .missing_references import LaunchContext


@dataclass(frozen=True, slots=True)
class ArgumentMismatch:
    span: Span
    file: str
    """The name of the included file."""
    package: str
    argument: str
    is_missing: bool
    """Whether it is required and missing; else it is passed and unknown."""
    suggestion: str | None = None


@dataclass(frozen=True)
class IncludeContext:
    scope: LaunchContext

    def mismatches(self) -> Iterator[ArgumentMismatch]:
        """Yield the unknown and the missing arguments of includes, as far as the included file is known."""
        for include in self.scope.file.includes if not (self.scope.file.is_ros1 or self.scope.is_unused_test) else ():
            target = self.target(include)
            if target is not None:
                package, signature = target
                yield from self.mismatches_of(include, package, signature)

    def target(self, include: Include) -> tuple[str, LaunchSignature] | None:
        folder = self.scope.file.path.rpartition("/")[0]
        named = next(references_in(include.file, folder, "include"), None)
        known = self.scope.workspace.included_arguments
        return known.find(self.scope.package.name, named.package, named.path) if named is not None else None

    def mismatches_of(self, include: Include, package: str, signature: LaunchSignature) -> Iterator[ArgumentMismatch]:
        name = signature.source.rpartition("/")[2]
        given = {text.literal: text for text, _ in include.arguments}
        takes = self.scope.workspace.included_arguments.takes(package, signature.source)
        for argument, text in given.items():
            if argument and takes is not None and argument not in takes:
                free = signature.declared - given.keys()
                yield ArgumentMismatch(text.span, name, package, argument, False, nearest(argument, free))
        for argument in sorted(signature.required - given.keys()):
            if include.is_complete and None not in given:
                yield ArgumentMismatch(include.span, name, package, argument, True)
