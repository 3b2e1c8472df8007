"""Findings on dependencies that are used and not declared, and that a declared dependency brings."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

from ..checks.depends.brought_dependencies import Bringer
from ..checks.depends.circles import circle_with
from ..checks.depends.declared_dependencies import DeclaredDependencies
from ..checks.depends.undeclared_includes import IncludeDependencies
from ..checks.enumeration import in_ticks
from ..finding import Hit, Related, Severity
from ..light_dataclasses import dataclass
from ..source import Span
from .undeclared_dependency import declarations

if TYPE_CHECKING:
    from ..checks.depends.included_packages import IncludedPackage

MAX_RELATED = 3


@dataclass(frozen=True, slots=True)
class BroughtUse:
    """A dependency that is used and that a declared one brings today, or may bring."""

    name: str
    bringer: Bringer
    tag: str
    """Under which it is to be declared."""
    path: str
    span: Span
    """Where it is used first."""


def brought_includes(includes: IncludeDependencies) -> list[BroughtUse]:
    """Return the undeclared packages that C++ includes and that something else brings, or may bring."""
    return [
        BroughtUse(each.names[0], bringer, tag_of(each), each.uses[0].path, each.uses[0].span)
        for each, bringer in includes.brought()
    ]


def tag_of(each: IncludedPackage) -> str:
    return "test_depend" if each.role == "test" else "depend"


def left_to_others(declared: DeclaredDependencies, uses: Sequence[BroughtUse], used: str) -> Iterator[Hit]:
    """Yield one info for all that declared dependencies bring, or may bring, first what they certainly bring.

    `used` says how it is used: "imported". A package that depends on this one can't be declared, and has its own info.
    """
    circles = {use.name: circle for use in uses if (circle := circle_with(declared, use.name))}
    for use in uses:
        if use.name in circles:
            yield left_in_circle(use, circles[use.name].why(use.name), used)
    if rest := [use for use in uses if use.name not in circles]:
        yield left_to_some(declared, sorted(rest, key=lambda use: not use.bringer.is_certain), used)


def left_in_circle(use: BroughtUse, why: str, used: str) -> Hit:
    message = f"`{use.name}` is {used} and not declared: {comes_with(use.bringer)}; {why}"
    return Hit(use.path, use.span, message, Severity.INFO)


def left_to_some(declared: DeclaredDependencies, uses: Sequence[BroughtUse], used: str) -> Hit:
    names = [use.name for use in uses]
    bringers = {use.bringer.name for use in uses}
    who = in_ticks([*bringers]) if len(bringers) == 1 else "other dependencies"
    be, it, comes = ("is", "it", "comes") if len(uses) == 1 else ("are", "they", "come")
    surely = {use.bringer.is_certain for use in uses}
    may = "may come" if surely == {False} else "come or may come"
    come = f"{comes} with {who} today" if surely == {True} else f"{may} with {who}"
    message = f"{in_ticks(names)} {be} {used} and not declared: {it} {come}; declare what you use"
    first, *others = uses
    by = {use.name: by_way_of(use.bringer) if len(bringers) > 1 else "" for use in uses}
    places = tuple(Related(use.path, use.span, f"`{use.name}` here{by[use.name]}") for use in others)
    fix = declarations(declared, [(use.tag, use.name) for use in uses])
    return Hit(first.path, first.span, message, Severity.INFO, places, fix)


def by_way_of(bringer: Bringer) -> str:
    return f"{',' if bringer.is_certain else ', perhaps'} by way of `{bringer.name}`"


def comes_with(bringer: Bringer) -> str:
    """Return which dependency brings another one, as a clause."""
    return f"it comes with `{bringer.name}` today" if bringer.is_certain else f"it may come with `{bringer.name}`"


def related(places: Iterable[tuple[str, Span]]) -> tuple[Related, ...]:
    """Return the places other than the first."""
    return tuple(Related(path, span, "and here") for path, span in [*places][1 : MAX_RELATED + 1])
