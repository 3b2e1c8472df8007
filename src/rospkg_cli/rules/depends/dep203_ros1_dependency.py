"""DEP203 ros1-dependency."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ...checks.depends.dependency_names import DependencyNames
from ...checks.depends.unneeded_names import SKIPPED
from ...edits.manifest import remove_element
from ...example import Example, manifest
from ...finding import Fix, Hit, Related, Safety, Severity
from ...package.dependency import Dependency
from ...package.manifest import Manifest
from ...ros.aliases import successors
from ...rule import rule

OF_INTERFACES = frozenset({"message_generation", "message_runtime"})


@rule(
    "DEP203",
    "ros1-dependency",
    over=DependencyNames,
    severity=Severity.WARNING,
    levels={Severity.INFO: "where ROS 1 had it, and nothing says that it went away, or a page has rosdep skip it"},
    examples=(
        Example(
            bad={"package.xml": manifest("  <exec_depend>«rospy»</exec_depend>\n")},
            good={"package.xml": manifest("  <exec_depend>rclpy</exec_depend>\n")},
        ),
        Example(
            bad={"package.xml": manifest("  <exec_depend>«rospy»</exec_depend>\n")},
            good={
                "package.xml": manifest('  <exec_depend condition="$ROS_VERSION == 1">rospy</exec_depend>\n'),
            },
        ),
        Example(
            bad={"package.xml": manifest("  <build_depend>«message_generation»</build_depend>\n")},
            good={"package.xml": manifest()},
            fix=Safety.UNSAFE,
        ),
        Example(
            bad={"package.xml": manifest("  <exec_depend>«rosserial_python»</exec_depend>\n")},
            good={"package.xml": manifest()},
        ),
    ),
)
def ros1_dependency(names: DependencyNames) -> Iterator[Hit]:
    """
    ## What it does
    Finds dependencies that exist only in ROS 1, such as `rospy`, `catkin`, `message_generation`.
    Those whose condition excludes ROS 2 are left alone. Known are the packages that took a new name or went away, and
    all that distributions of ROS 1 released and none of ROS 2 ever listed.

    ## Why is this bad?
    `rosdep install` ends with "Cannot locate rosdep definition for [rospy]".

    ## When it is quiet
    A dependency whose condition excludes ROS 2 (`$ROS_VERSION == 1`) is left alone, and so is a package of that name in
    the workspace. Whether somebody has ported a package that was only released for ROS 1 is unknown: it is an info, and
    nothing is said where a repository that a `.repos` file lists is called like it. What a page, a script or a job here
    has rosdep skip (`--skip-keys`) is an info.

    ## Fix safety
    A line for interfaces is removed where the package has none, or declares what makes them in ROS 2 already; a build
    for ROS 1 may still need it.
    """
    manifest = names.declared.manifest
    for each, distro in names.released_for_ros1():
        message = (
            f"`{each.name}` was released for ROS 1 only (last for {distro}): `rosdep install` ends with "
            f'"Cannot locate rosdep definition for [{each.name}]"; replace it, or put a port of it into the workspace'
        )
        yield Hit(manifest.path, each.span, message, Severity.INFO, further(names, each))
    for each in names.active():
        taken = successors(each.name)
        if taken is None or names.declared.workspace.named(each.name) is not None:
            continue
        needless = each.name in OF_INTERFACES and (not names.has_interfaces or has_any(manifest, taken))
        instead = " or ".join(f"`{name}`" for name in taken)
        todo = f"in ROS 2 it is {instead}" if taken else "ROS 2 needs nothing for it here: remove the line"
        if needless:
            todo = "ROS 2 needs nothing for it here: remove the line"
        elif taken and has_any(manifest, taken):
            todo += ", which is declared already: remove the line"
        message = (
            f'`{each.name}` is a package of ROS 1: `rosdep install` ends with "Cannot locate rosdep definition for '
            f'[{each.name}]"; {todo} (or add condition="$ROS_VERSION == 1")'
        )
        same = (each, *(other for other in names.repeated(each) if other.condition is None))
        edits = tuple(remove_element(manifest, found.element) for found in same)
        fix = Fix(f"remove `{each.name}`", edits, Safety.UNSAFE) if needless else None
        is_skipped = names.unneeded.is_skipped(each.name)
        level, message = (Severity.INFO, message + SKIPPED) if is_skipped else (None, message)
        yield Hit(manifest.path, each.span, message, level, further(names, each), fix)


def further(names: DependencyNames, first: Dependency) -> tuple[Related, ...]:
    path = names.declared.manifest.path
    return tuple(Related(path, other.span, "and here") for other in names.repeated(first))


def has_any(manifest: Manifest, names: Iterable[str]) -> bool:
    return any(manifest.depends_on(name) for name in names)
