"""XML207 ament-python-dependency."""

from __future__ import annotations

from collections.abc import Iterator

from ...edits.manifest import remove_element
from ...example import Example, manifest
from ...finding import Fix, Hit, Safety, Severity
from ...package.manifest import Manifest
from ...rule import rule


@rule(
    "XML207",
    "ament-python-dependency",
    over=Manifest,
    severity=Severity.WARNING,
    examples=(
        Example(
            bad={"package.xml": manifest("  «<buildtool_depend>ament_python</buildtool_depend>»\n")},
            good={"package.xml": manifest()},
            fix=Safety.SAFE,
        ),
    ),
)
def ament_python_dependency(manifest: Manifest) -> Iterator[Hit]:
    """
    ## What it does
    Finds a dependency on `ament_python`.
    The build type of that name is right; a package of that name does not exist.

    ## Why is this bad?
    `rosdep install` ends with "Cannot locate rosdep definition for [ament_python]", and bloom refuses to release.

    ## When it is quiet
    A `<build_type>ament_python</build_type>`, which is right, is left alone.
    """
    for each in manifest.dependencies:
        if each.name == "ament_python":
            message = (
                '`ament_python` is a build type, not a package: `rosdep install` fails with "Cannot locate rosdep '
                'definition for [ament_python]"; remove this line and keep `<build_type>ament_python</build_type>`'
            )
            fix = Fix("Remove `ament_python`", (remove_element(manifest, each.element),))
            yield Hit(manifest.path, each.element.span, message, fix=fix)
