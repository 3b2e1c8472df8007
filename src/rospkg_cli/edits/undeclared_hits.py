"""From dependencies that are used and not declared to what a rule says and offers."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

from ..checks.depends.brought_dependencies import Bringer
from ..checks.depends.circles import circle_with
from ..checks.depends.commented_installs import LEFT, is_installed_by_comment
from ..checks.depends.declared_dependencies import DeclaredDependencies
from ..checks.depends.name_source import is_of_family, only_distros, source_of
from ..checks.depends.pip_requirements import FRAMEWORKS
from ..checks.depends.similar_names import SimilarNames
from ..checks.depends.split_distributions import split_distributions
from ..checks.depends.system_installs import TOLD
from ..checks.depends.undeclared_includes import IncludeDependencies
from ..checks.enumeration import enumerated, in_ticks
from ..finding import Fix, Hit, Related, Safety, Severity
from ..light_dataclasses import dataclass
from ..source import Span
from .manifest import add_dependencies

if TYPE_CHECKING:
    from ..checks.depends.included_packages import IncludedPackage

MAX_RELATED = 3

IN_FORMAT_1 = {
    "depend": ("build_depend", "run_depend"), "exec_depend": ("run_depend",), "build_export_depend": ("run_depend",),
}  # fmt: skip
"""The tags that stand for those which format 1 does not have (REP-127); catkin_pkg refuses a manifest with others."""


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
    """Return what C++ includes undeclared, and what something else brings, or may bring."""
    return [
        BroughtUse(each.names[0], bringer, tag_of(each), each.uses[0].path, each.uses[0].span)
        for each, bringer in includes.brought()
    ]


def tag_of(each: IncludedPackage) -> str:
    return "test_depend" if each.role == "test" else "depend"


def related(places: Iterable[tuple[str, Span]]) -> tuple[Related, ...]:
    """Return the places other than the first."""
    return tuple(Related(path, span, "and here") for path, span in [*places][1 : MAX_RELATED + 1])


def where_absent(declared: DeclaredDependencies, *names: str, built: bool = False) -> str:
    """Return where what is not declared is missing when the package runs, or is `built`, by the names that provide it.

    colcon builds all of a workspace unless it is asked for a part, and rosdep installs what any package of it declares.
    """
    if any(declared.workspace.named(name) for name in names):
        return f"after `colcon build --packages-up-to {declared.facts.name}`"
    if declared.otherwise.is_lacked_by_releases(names):
        return "on the build farm" if built else "in a release"
    return "on a clean machine"


def advice(declared: DeclaredDependencies, tag: str, name: str, *serving: str) -> str:
    """Return what to do about a missing dependency, and where else its repository gets it, by any name that serves."""
    if circle := circle_with(declared, name):
        return circle.why(name)
    if name in declared.for_other_distributions:
        return "package.xml declares it for distributions alone that are supported no more: widen the condition"
    left = LEFT if is_installed_by_comment(declared.manifest, (name, *serving)) else ""
    return f"{todo(declared, tag, name, *serving)}{left}"


def todo(declared: DeclaredDependencies, tag: str, name: str, *serving: str) -> str:
    """Return what to do about a dependency that nothing but its source keeps from being declared."""
    match source_of(declared, name):
        case "released":
            only = only_for(declared, name)
            told = TOLD if declared.otherwise.is_by_command((name, *serving)) else ""
            return f"add {written(declared, tag, name)}{only}{told}"
        case "pip":
            return f"<{tag}>{name}</{tag}> installs it from PyPI, and prevents a release"
        case "unknown" if told := declared.otherwise.hidden.told(name):
            return told
        case "unknown" if near := SimilarNames(declared.workspace).meant(name):
            return f"did you mean `{near}`?"
        case "unknown" if not declared.workspace.is_complete:
            return "a repository that is listed and not checked out may have it"
        case "unknown" if is_of_family(declared, name):
            return "another repository of its family may have it: list that in a .repos file"
        case "unknown":
            return "no supported distribution has it: correct the name, or list its repository in a .repos file"


def only_for(declared: DeclaredDependencies, name: str) -> str:
    """Return which distributions alone have what is to be declared, or which of those named here lack it."""
    if few := only_distros(declared, name):
        return f", which only {enumerated(few)} {'have' if few[1:] else 'has'}"
    split = split_distributions(declared, name)
    if not split.without:
        return ""
    lack = f": {enumerated(split.without)}, which the repository names, {'lack' if split.without[1:] else 'lacks'} it"
    return lack if split.is_for_some else f"{lack}, so list its repository in a .repos file"


def declaration(declared: DeclaredDependencies, tag: str, name: str) -> Fix | None:
    """Return the fix that declares a dependency; None where it would make a circle."""
    if circle_with(declared, name):
        return None
    conditions = {name: condition_of(declared, name)}
    edits = add_dependencies(declared.manifest, ((each, name) for each in tags(declared, tag)), conditions)
    return Fix(f"add {written(declared, tag, name)}", edits, safety_of(declared, name))


def condition_of(declared: DeclaredDependencies, name: str) -> str:
    """Return the condition under which a dependency is declared, for some of the distributions that are named."""
    has_conditions = declared.manifest.schema_format >= 3
    return split_distributions(declared, name).condition if has_conditions else ""


def tags(declared: DeclaredDependencies, tag: str) -> tuple[str, ...]:
    """Return the tags that say in the manifest's format what a tag of format 3 says."""
    return IN_FORMAT_1.get(tag, (tag,)) if declared.manifest.schema_format == 1 else (tag,)


def written(declared: DeclaredDependencies, tag: str, name: str) -> str:
    condition = condition_of(declared, name)
    attribute = f' condition="{condition}"' if condition else ""
    return " and ".join(f"<{each}{attribute}>{name}</{each}>" for each in tags(declared, tag))


def safety_of(declared: DeclaredDependencies, name: str) -> Safety:
    """Return whether a name may be declared unasked: all distributions have it, and it was not left out on purpose.

    Where some that the repository names lack it, a condition does it for the others.
    """
    is_left = name in declared.commented_out or name in declared.for_other_distributions
    is_left = is_left or name.removeprefix("python3-") in FRAMEWORKS
    is_left = is_left or is_installed_by_comment(declared.manifest, (name,))
    split = split_distributions(declared, name)
    is_left = is_left or (bool(split.without) and not condition_of(declared, name))
    sure = source_of(declared, name) == "released" and not is_left
    return Safety.SAFE if sure and not only_distros(declared, name) else Safety.UNSAFE


def left_to_others(declared: DeclaredDependencies, uses: Sequence[BroughtUse], used: str) -> Iterator[Hit]:
    """Yield one info for all that declared dependencies bring, or may bring; what certainly comes is named first.

    `used` is what is done: "imported". What may not be declared, as it needs this package, has one of its own.
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


def declarations(declared: DeclaredDependencies, wanted: Sequence[tuple[str, str]]) -> Fix:
    """Return the fix that declares several dependencies, each as (tag, name): the safe ones if there are any."""
    safe = [(tag, name) for tag, name in wanted if safety_of(declared, name) is Safety.SAFE]
    asked = safe or wanted
    conditions = {name: condition_of(declared, name) for _, name in asked}
    pairs = ((each, name) for tag, name in asked for each in tags(declared, tag))
    edits = add_dependencies(declared.manifest, pairs, conditions)
    return Fix(f"declare {in_ticks(name for _, name in asked)}", edits, Safety.SAFE if safe else Safety.UNSAFE)


def by_way_of(bringer: Bringer) -> str:
    return f"{',' if bringer.is_certain else ', perhaps'} by way of `{bringer.name}`"


def comes_with(bringer: Bringer) -> str:
    """Return who brings a dependency, as a clause."""
    return f"it comes with `{bringer.name}` today" if bringer.is_certain else f"it may come with `{bringer.name}`"
