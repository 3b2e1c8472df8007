"""XML002 element-order."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator

from ...edits.reorder import reorder, schema_order
from ...example import Example, manifest
from ...finding import Fix, Hit, Safety, Severity
from ...languages.xml.elements import Element
from ...package.manifest import Manifest
from ...package.schema.schema import misplaced
from ...ros.manifest import place_of
from ...rule import rule

MAX_OFFERS = 100
"""Each finding offers the one fix of them all; of more findings than these, only the first do."""

GOOD = manifest().replace(
    "</license>\n", "</license>\n  <url>https://example.org</url>\n  <!-- she began it -->\n  <author>Bob</author>\n"
)
BAD = (
    manifest()
    .replace("  <license>", "  <!-- she began it -->\n  «<author>Bob</author>»\n  <license>")
    .replace("</license>\n", "</license>\n  <url>https://example.org</url>\n")
)


@rule(
    "XML002",
    "element-order",
    over=Manifest,
    severity=Severity.WARNING,
    examples=(Example(bad={"package.xml": BAD}, good={"package.xml": GOOD}, fix=Safety.SAFE),),
)
def element_order(manifest: Manifest) -> Iterator[Hit]:
    """
    ## What it does
    Finds children of `<package>` that are not in the schema's order.
    The order is name, version, description, maintainer, license, url, author, dependencies (in any order),
    group_depend, member_of_group, export.

    ## Why is this bad?
    colcon does not mind. `ament_xmllint`, which the tests of every package made by `ros2 pkg create` run, fails on it,
    and so does every editor that checks against the schema.

    ## References
    - [REP-149, Schema](https://ros.org/reps/rep-0149.html#schema)
    """
    if manifest.verdict.is_ordered:
        return
    edits = tuple(reorder(manifest, schema_order(manifest)))
    fix = Fix("Put the elements of package.xml in order", edits) if edits else None
    moving = misplaced(manifest.root.children)
    moved = set(moving)
    staying = [child for child in manifest.root.children if child not in moved]
    places = [place_of(child.tag) for child in staying]
    for number, element in enumerate(moving):
        where = neighbour(staying, bisect_right(places, place_of(element.tag)), element)
        message = f"`<{element.tag}>` must be {where}; `colcon test` fails on it where ament_xmllint is run"
        span = element.open if element.children else element.span
        yield Hit(manifest.path, span, message, fix=fix if number < MAX_OFFERS else None)


def neighbour(staying: list[Element], at: int, element: Element) -> str:
    """Return where an element belongs: before `staying[at]`, said by the one that it should come after or before."""
    if at and (at == len(staying) or staying[at - 1].span.start > element.span.start):
        return f"after `<{staying[at - 1].tag}>`"
    return f"before `<{staying[at].tag}>`"
