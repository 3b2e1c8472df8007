"""An undeclared dependency: where it is missing, what to do about it, and the fix that declares it in package.xml."""

from __future__ import annotations

from collections.abc import Sequence

from ..checks.depends.circles import circle_with
from ..checks.depends.commented_installs import LEFT, is_installed_by_comment
from ..checks.depends.declared_dependencies import DeclaredDependencies
from ..checks.depends.name_source import is_of_family, only_distros, source_of
from ..checks.depends.pip_requirements import FRAMEWORKS
from ..checks.depends.similar_names import SimilarNames
from ..checks.depends.split_distributions import split_distributions
from ..checks.depends.system_installs import BY_COMMAND
from ..checks.enumeration import enumerated, in_ticks
from ..finding import Fix, Safety
from .manifest import add_dependencies

IN_FORMAT_1 = {
    "depend": ("build_depend", "run_depend"), "exec_depend": ("run_depend",), "build_export_depend": ("run_depend",),
}  # fmt: skip
"""The tags of format 1 for those that it does not have (REP-127); catkin_pkg refuses a manifest with others."""


def where_absent(declared: DeclaredDependencies, *names: str, built: bool = False) -> str:
    """Return where an undeclared dependency is missing when the package runs, or is `built`; `names` may provide it.

    colcon builds a whole workspace unless it is asked for a part, and rosdep installs what any package in it declares.
    """
    if any(declared.workspace.named(name) for name in names):
        return f"after `colcon build --packages-up-to {declared.facts.name}`"
    if declared.otherwise.is_lacked_by_releases(names):
        return "on the build farm" if built else "in a release"
    return "on a clean machine"


def advice(declared: DeclaredDependencies, tag: str, name: str, *serving: str) -> str:
    """Return what to do about a missing dependency, and where else the repository gets it; `serving` are other names
    of it.
    """
    if circle := circle_with(declared, name):
        return circle.why(name)
    if name in declared.for_other_distributions:
        return "package.xml declares it for distributions alone that are supported no more: widen the condition"
    left = LEFT if is_installed_by_comment(declared.manifest, (name, *serving)) else ""
    return f"{todo(declared, tag, name, *serving)}{left}"


def todo(declared: DeclaredDependencies, tag: str, name: str, *serving: str) -> str:
    """Return what to do about a missing dependency, by the source that has it."""
    match source_of(declared, name):
        case "released":
            only = only_for(declared, name)
            otherwise = BY_COMMAND if declared.otherwise.is_by_command((name, *serving)) else ""
            return f"add {written(declared, tag, name)}{only}{otherwise}"
        case "pip":
            return f"<{tag}>{name}</{tag}> installs it from PyPI, and prevents a release"
        case "unknown" if hidden := declared.otherwise.hidden.where(name):
            return hidden
        case "unknown" if near := SimilarNames(declared.workspace).intended(name):
            return f"did you mean `{near}`?"
        case "unknown" if not declared.workspace.is_complete:
            return "a repository that is listed and not checked out may have it"
        case "unknown" if is_of_family(declared, name):
            return "another repository of its family may have it: list that in a .repos file"
        case "unknown":
            return "no supported distribution has it: correct the name, or list its repository in a .repos file"


def only_for(declared: DeclaredDependencies, name: str) -> str:
    """Return which few distributions have a dependency, or which of those that the repository names lack it."""
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
    """Return the condition for a dependency that only some of the distributions here have; "" for others."""
    has_conditions = declared.manifest.schema_format >= 3
    return split_distributions(declared, name).condition if has_conditions else ""


def tags(declared: DeclaredDependencies, tag: str) -> tuple[str, ...]:
    """Return the tags of the manifest's format for a tag of format 3."""
    return IN_FORMAT_1.get(tag, (tag,)) if declared.manifest.schema_format == 1 else (tag,)


def written(declared: DeclaredDependencies, tag: str, name: str) -> str:
    condition = condition_of(declared, name)
    attribute = f' condition="{condition}"' if condition else ""
    return " and ".join(f"<{each}{attribute}>{name}</{each}>" for each in tags(declared, tag))


def safety_of(declared: DeclaredDependencies, name: str) -> Safety:
    """Return whether a name may be declared without asking: all distributions have it, and it was not left out.

    Where some that the repository names lack it, it is safe under a condition.
    """
    is_left = name in declared.commented_out or name in declared.for_other_distributions
    is_left = is_left or name.removeprefix("python3-") in FRAMEWORKS
    is_left = is_left or is_installed_by_comment(declared.manifest, (name,))
    split = split_distributions(declared, name)
    is_left = is_left or (bool(split.without) and not condition_of(declared, name))
    sure = source_of(declared, name) == "released" and not is_left
    return Safety.SAFE if sure and not only_distros(declared, name) else Safety.UNSAFE


def declarations(declared: DeclaredDependencies, wanted: Sequence[tuple[str, str]]) -> Fix:
    """Return the fix that declares several dependencies, each as (tag, name): the safe ones if there are any."""
    safe = [(tag, name) for tag, name in wanted if safety_of(declared, name) is Safety.SAFE]
    asked = safe or wanted
    conditions = {name: condition_of(declared, name) for _, name in asked}
    pairs = ((each, name) for tag, name in asked for each in tags(declared, tag))
    edits = add_dependencies(declared.manifest, pairs, conditions)
    return Fix(f"declare {in_ticks(name for _, name in asked)}", edits, Safety.SAFE if safe else Safety.UNSAFE)
