"""XML210 empty-dependency."""

from __future__ import annotations

from collections.abc import Iterator

from ...edits.manifest import remove_element
from ...example import Example, manifest
from ...finding import Fix, Hit, Safety, Severity
from ...package.manifest import Manifest
from ...ros.manifest import NEW_IN
from ...rule import rule


@rule(
    "XML210",
    "empty-dependency",
    over=Manifest,
    severity=Severity.WARNING,
    examples=(
        Example(
            bad={"package.xml": manifest("  «<exec_depend/>»\n")},
            good={"package.xml": manifest()},
            fix=Safety.SAFE,
        ),
    ),
)
def empty_dependency(manifest: Manifest) -> Iterator[Hit]:
    """
    ## What it does
    Finds dependencies and groups without a name.

    ## Why is this bad?
    colcon ignores them: the build is green. `rosdep install` looks up a key without a name and fails, and bloom writes
    a Debian control file that can't be read.

    ## When it is quiet
    An element that holds other elements is left to XML001.
    """
    for element in [*(each.element for each in manifest.dependencies), *manifest.all(*NEW_IN[3])]:
        if not element.text and not element.children:
            fix = Fix(f"Remove the empty `<{element.tag}>`", (remove_element(manifest, element),))
            message = (
                f"`<{element.tag}>` names nothing: `rosdep install` fails on it; name the dependency or remove the line"
            )
            yield Hit(manifest.path, element.span, message, fix=fix)
