"""XML206 unsorted-dependencies."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from ...edits.reorder import reorder, sorted_in_place
from ...example import Example, manifest
from ...finding import Fix, Hit, Safety, Severity
from ...package.manifest import Manifest
from ...ros.manifest import DEPENDENCY_TAGS
from ...rule import Profile, rule

GOOD = manifest("  <exec_depend>rclpy</exec_depend>\n  <!-- frames -->\n  <exec_depend>tf2_ros</exec_depend>\n")
BAD = manifest("  <!-- frames -->\n  <exec_depend>tf2_ros</exec_depend>\n  <exec_depend>«rclpy»</exec_depend>\n")


@rule(
    "XML206",
    "unsorted-dependencies",
    over=Manifest,
    severity=Severity.INFO,
    profile=Profile.PEDANTIC,
    examples=(Example(bad={"package.xml": BAD}, good={"package.xml": GOOD}, fix=Safety.SAFE),),
)
def unsorted_dependencies(manifest: Manifest) -> Iterator[Hit]:
    """
    ## What it does
    Finds dependencies of one tag that are not sorted alphabetically.
    The fix sorts each tag in the places that it has; `rospkg format` also brings the tags together.

    ## Why is this bad?
    It is a matter of taste: in a sorted list duplicates are easy to see, and additions rarely conflict.

    ## When it is quiet
    It runs with `--pedantic` alone. Only lines of one tag are compared.
    """
    for tag in DEPENDENCY_TAGS:
        found = manifest.all(tag)
        late = next((b for a, b in pairwise(found) if b.text < a.text), None)
        if late is None:
            continue
        edits = tuple(reorder(manifest, sorted_in_place(manifest, tag)))
        message = f"`<{tag}>{late.text}</{tag}>` is not sorted alphabetically; sort the `<{tag}>` lines"
        fix = Fix(f"Sort the `<{tag}>` lines", edits) if edits else None
        yield Hit(manifest.path, manifest.span(late), message, fix=fix)
