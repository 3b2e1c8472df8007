"""XML002 element-order."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Iterable, Iterator
from itertools import groupby

from ...checks.manifest.schema_tests import SchemaTests
from ...edits.reorder import reorder, schema_order
from ...example import XMLLINT, Example, manifest
from ...finding import Fix, Hit, Related, Safety, Severity
from ...languages.xml.elements import Element
from ...package.schema.schema import misplaced
from ...package.schema_line import names_schema
from ...ros.manifest import ORDER, place_of
from ...rule import rule
from ...source import Span

MAX_OFFERS = 100
"""Each finding offers the one fix of them all; of more findings than these, only the first do."""

MAX_RELATED = 3

CHECKED = manifest("  <test_depend>ament_xmllint</test_depend>\n")
GOOD = CHECKED.replace(
    "</license>\n", "</license>\n  <url>https://example.org</url>\n  <!-- she began it -->\n  <author>Bob</author>\n"
)
BAD = CHECKED.replace("  <license>", "  <!-- she began it -->\n  «<author>Bob</author>»\n  <license>").replace(
    "</license>\n", "</license>\n  <url>https://example.org</url>\n"
)


@rule(
    "XML002",
    "element-order",
    over=SchemaTests,
    severity=Severity.WARNING,
    levels={Severity.INFO: "where no test checks it: none runs ament_xmllint, or package.xml names no schema"},
    examples=(
        Example(bad={"package.xml": BAD, "test/test_xmllint.py": XMLLINT}, good={"package.xml": GOOD}, fix=Safety.SAFE),
    ),
)
def element_order(tests: SchemaTests) -> Iterator[Hit]:
    """
    ## What it does
    Finds children of `<package>` that are not in the schema's order.
    The order is name, version, description, maintainer, license, url, author, dependencies (in any order),
    group_depend, member_of_group, export.

    ## Why is this bad?
    colcon does not mind. `ament_xmllint`, which comes with ament_lint_common into the tests of every package made by
    `ros2 pkg create --build-type ament_cmake`, fails on it, and so does every editor that checks against the schema.

    ## When it is quiet
    Where no `<?xml-model …?>` line names the schema, no tool checks the order, and nothing is said. It is an info where
    the package declares neither ament_lint_common nor ament_xmllint as `<test_depend>`, for ament_lint_auto finds no
    others unless CMake does, and where that line has an empty `href` or no `schematypens` of XML Schema. What stands
    wrong in a row under one tag is one finding.

    ## References
    - [REP-149, Schema](https://ros.org/reps/rep-0149.html#schema)
    """
    manifest = tests.manifest
    if manifest.verdict.is_ordered or manifest.xml_model is None:
        return
    edits = tuple(reorder(manifest, schema_order(manifest)))
    fix = Fix("Put the elements of package.xml in order", edits) if edits else None
    children = [child for child in manifest.root.children if place_of(child.tag) < len(ORDER)]  # XML001 reports others
    moving = misplaced(children)
    moved = set(moving)
    staying = [child for child in children if child not in moved]
    places = [place_of(child.tag) for child in staying]
    if not names_schema(manifest):
        level, ends = Severity.INFO, "no tool checks it while the `<?xml-model?>` line names no schema of this format"
    elif not tests.is_tested:
        level, ends = Severity.INFO, "`ament_xmllint` and editors that know the schema refuse it"
    else:
        level, ends = None, "`colcon test` fails on it, since the tests run ament_xmllint"
    for number, (element, *others) in enumerate(in_groups(moving)):
        message = f"`<{element.tag}>` must be {neighbour(staying, places, element)}: {ends}"
        same = tuple(Related(manifest.path, span_of(each), "and here") for each in others[:MAX_RELATED])
        yield Hit(manifest.path, span_of(element), message, level, same, fix if number < MAX_OFFERS else None)


def in_groups(moving: Iterable[Element]) -> Iterator[list[Element]]:
    """Yield the elements of one tag together, where they were found one after the other."""
    return (list(group) for _, group in groupby(moving, key=lambda element: element.tag))


def span_of(element: Element) -> Span:
    return element.open if element.children else element.span


def neighbour(staying: list[Element], places: list[int], element: Element) -> str:
    """Return where an element belongs, said by the nearest that the schema puts before or after it."""
    place = place_of(element.tag)
    start = bisect_left(places, place)
    end = bisect_right(places, place)
    if start and (end == len(staying) or staying[start - 1].span.start > element.span.start):
        return f"after `<{staying[start - 1].tag}>`"
    return f"before `<{staying[end].tag}>`"
