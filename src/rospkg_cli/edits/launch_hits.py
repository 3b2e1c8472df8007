"""From what is described to be launched, and not declared, to what DEP103 says of all of it at once."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ..checks.depends.declared_dependencies import DeclaredDependencies
from ..checks.enumeration import enumerated, in_ticks
from ..checks.launch.package_reference import PackageReference
from ..finding import Fix, Hit, Related, Severity
from ..source import Span
from .manifest import add_dependency
from .undeclared_dependency import declarations


def described_nodes(
    declared: DeclaredDependencies, nodes: Sequence[tuple[str, str, Span]], tag: str = "exec_depend"
) -> Iterator[Hit]:
    """Yield one info for the packages that code describes nodes of, each as (name, path, span).

    Who launches such nodes may declare them.
    """
    if not nodes:
        return
    (_, path, span), *others = nodes
    are, of_it, it = ("are", "nodes of them", "them") if others else ("is", "a node of it", "it")
    message = (
        f"{in_ticks(name for name, *_ in nodes)} {are} not declared, and this code describes {of_it}: where a launch "
        f'starts one, it stops with "package not found" on a clean machine; declare {it} as {tag}'
    )
    fix = declarations(declared, [(tag, name) for name, *_ in nodes])
    places = tuple(Related(other, at, f"`{name}` here") for name, other, at in others)
    yield Hit(path, span, message, Severity.INFO, places, fix)


def no_launch(declared: DeclaredDependencies, missing: dict[str, list[PackageReference]]) -> Hit:
    """Ask for ros2launch once, whatever of launch itself is missing."""
    first = min((use for uses in missing.values() for use in uses), key=lambda use: (use.path, use.span))
    line = "<exec_depend>ros2launch</exec_depend>"
    names = enumerated(f"`{name}`" for name in missing)
    message = (
        f"this launch file needs {names}, which nothing in package.xml brings: `ros2 launch` may be missing where it "
        f"is installed; add {line}"
    )
    fix = Fix(f"add {line}", (add_dependency(declared.manifest, "exec_depend", "ros2launch"),))
    return Hit(first.path, first.span, message, Severity.INFO, fix=fix)
