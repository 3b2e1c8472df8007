"""WSP002 dependency-cycle."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.workspace.dependency_cycles import DependencyStep, dependency_cycles
from ...example import Example, manifest
from ...finding import Hit, Related, Severity
from ...package.workspace import Workspace
from ...rule import rule


@rule(
    "WSP002",
    "dependency-cycle",
    over=Workspace,
    severity=Severity.ERROR,
    examples=(
        Example(
            on="",
            bad={
                "arm/package.xml": manifest("  <depend>«hand»</depend>\n", "cmake", "arm"),
                "hand/package.xml": manifest("  <test_depend>arm</test_depend>\n", "cmake", "hand"),
            },
            good={"hand/package.xml": manifest("", "cmake", "hand")},
        ),
        Example(
            on="",
            bad={
                "arm/package.xml": manifest("  <group_depend>«hands»</group_depend>\n", "cmake", "arm"),
                "hand/package.xml": manifest(
                    "  <exec_depend>arm</exec_depend>\n  <member_of_group>hands</member_of_group>\n", "cmake", "hand"
                ),
            },
            good={
                "hand/package.xml": manifest("  <member_of_group>hands</member_of_group>\n", "cmake", "hand"),
            },
        ),
    ),
)
def dependency_cycle(workspace: Workspace) -> Iterator[Hit]:
    """
    ## What it does
    Finds packages of one workspace that depend on each other in a cycle.
    Build, run and test dependencies count, and the members of a group that one depends on; only `doc_depend` does not.
    Each cycle is reported once, by its shortest path.

    ## Why is this bad?
    colcon builds nothing of the whole workspace: "Unable to order packages topologically".

    ## When it is quiet
    `doc_depend` does not count, nor does a dependency whose condition is false for the targets.

    ## References
    [REP-149](https://ros.org/reps/rep-0149.html), "Group dependencies"; colcon orders by build, run and test
    dependencies alike.
    """
    for steps in dependency_cycles(workspace):
        way = " → ".join([f"`{step.package.name}`" for step in steps] + [f"`{steps[0].package.name}`"])
        first, weak = steps[0], weakest(steps)
        message = (
            f"{way}: these packages wait for each other: colcon builds nothing (`Unable to order packages "
            f"topologically`); remove one dependency, perhaps `<{weak.need.tag}>{weak.need.name}` of "
            f"`{weak.package.name}`"
        )
        related = tuple(
            Related(each.package.at("package.xml"), each.need.span, f"so that it waits for `{each.needs.name}`")
            for each in steps[1:]
        )
        yield Hit(first.package.at("package.xml"), first.need.span, message, related=related)


def weakest(steps: tuple[DependencyStep, ...]) -> DependencyStep:
    """Return the step that is the easiest to do without: one for tests, else one to run, else the last."""
    return min(reversed(steps), key=lambda step: ("test_depend", "exec_depend", step.need.tag).index(step.need.tag))
