"""A file that a launch file names and that is missing where launch or a node looks for it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Literal

from ...light_dataclasses import dataclass
from ...package.launch.file_references import ReferenceKind
from ...package.launch.joined_path import OPEN
from ...package.launch.launched_parts import DeclaredArgument
from ...source import Span

USES: tuple[ReferenceKind, ...] = ("include", "open", "file", "default", "caught")
"""How a file is used, by how certain it is that the launch stops where it is missing."""
State = Literal["absent", "not installed", "elsewhere", "no slash"]


@dataclass(frozen=True, slots=True)
class MissingReference:
    """A missing file, with the place that names it and what happens there."""

    span: Span
    package: str
    path: str
    """Relative to the share directory of the package."""
    state: State
    use: ReferenceKind
    better_path: str | None = None
    """The file with the closest path; or, for `elsewhere`, where the file is installed."""
    other_spans: tuple[Span, ...] = ()
    """Other places that name it."""
    is_well_known: bool = False
    """Whether it is in a well-known package, whose sources are not here."""
    better_package: str = ""
    """The package of the better path, where it is well-known."""

    @property
    def is_for_rviz(self) -> bool:
        """Whether RViz opens it, which starts with its default view where it is missing."""
        return self.path.endswith(".rviz")

    @property
    def stops_launch(self) -> bool:
        """Whether the launch itself certainly opens it."""
        return self.use in ("include", "open") and not self.is_well_known and OPEN not in self.path


def defaults_of(arguments: Iterable[DeclaredArgument]) -> Iterator[Span]:
    """Yield where the defaults of arguments are written."""
    for each in arguments:
        if each.default is not None and each.default.parts:
            spans = (each.default.span, *(part.span for part in each.default.parts))
            yield Span(min(span.start for span in spans), max(span.end for span in spans))


def is_within(missing: MissingReference, around: Iterable[Span]) -> bool:
    """Return whether every place that names a file is one of some defaults, and none is given to a node as well."""
    spans = (missing.span, *missing.other_spans)
    inside = all(any(d.contains(span) for d in around) for span in spans)
    return inside and missing.use == "default"
