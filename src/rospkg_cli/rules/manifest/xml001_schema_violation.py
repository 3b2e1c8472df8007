"""XML001 schema-violation."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.manifest.misplaced_tag import RENAMED, intended_tag, is_group, is_of_format_2, misplaced_tag
from ...checks.manifest.schema_tests import SchemaTests
from ...checks.manifest.schema_values import before, faulty_value
from ...edits.manifest import rename_element
from ...example import Example, manifest
from ...finding import Fix, Hit, Related, Safety, Severity
from ...languages.xml.elements import Element
from ...package.manifest import Manifest
from ...package.schema.violation import Violation, ViolationKind
from ...ros.manifest import NEW_IN
from ...rule import rule
from ...source import Span

MAX_RELATED = 3
LOST = "colcon builds the folder as a plain package, which ROS does not find"
ELSEWHERE = {("name", ""), ("version", ""), ("maintainer", "email"), ("author", "email"), ("url", "type")}
"""Values that other rules judge; an attribute of any other tag is theirs as well."""

GOOD = manifest("  <exec_depend>rclpy</exec_depend>\n")


@rule(
    "XML001",
    "schema-violation",
    over=SchemaTests,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "only the schema forbids it, while colcon ignores it, and tests compare package.xml with it",
        Severity.INFO: "only the schema forbids it, and no test does that",
    },
    examples=(
        Example(
            bad={"package.xml": manifest("  «<run_depend>rclpy</run_depend>»\n")},
            good={"package.xml": GOOD},
            fix=Safety.SAFE,
        ),
        Example(
            bad={"package.xml": manifest("  «<exec_dependency>rclpy</exec_dependency>»\n")},
            good={"package.xml": GOOD},
            fix=Safety.UNSAFE,
        ),
        Example(
            bad={
                "package.xml": GOOD.replace("  <license>Apache-2.0</license>\n", "")
                .replace("<package f", "«<package f")
                .replace('"3">', '"3">»')
            },
            good={"package.xml": GOOD},
        ),
        Example(
            bad={"package.xml": manifest('  <exec_depend «type="ros"»>rclpy</exec_depend>\n')},
            good={"package.xml": GOOD},
        ),
    ),
)
def schema_violation(tests: SchemaTests) -> Iterator[Hit]:
    """
    ## What it does
    Finds what the schema of the manifest's own format (1, 2 or 3) forbids.
    Such are unknown tags and attributes, elements inside of text, tags that are missing or occur too often.

    ## Why is this bad?
    colcon, rosdep and bloom refuse such a package.xml. colcon does not stop at it: it takes the folder for a plain
    Python or CMake package, forgets the dependencies, builds in any order, and `ros2 run` does not find the package.

    ## When it is quiet
    What colcon ignores is a warning where the package declares ament_xmllint or ament_lint_common and names the schema,
    so that `colcon test` fails; else an info. Order, versions, addresses and features of format 3 are left to other
    rules.

    ## Fix safety
    The tag that is intended is written; where it is misspelt another one may be right.

    ## References
    - [REP-149](https://ros.org/reps/rep-0149.html), [REP-140](https://ros.org/reps/rep-0140.html),
      [REP-127](https://ros.org/reps/rep-0127.html)
    """
    manifest = tests.manifest
    newer = {each for each, _ in manifest.features_of_3} if manifest.schema_format < 3 else set()
    too_new = tuple(v.element for v in manifest.verdict.violations if is_of_format_2(manifest, v))
    for violation in manifest.verdict.violations:
        if violation.element in too_new[1:]:
            continue
        described = describe(manifest, violation)
        is_newer = violation.element in newer and violation.element not in too_new
        if described is not None and not (
            is_newer and violation.kind in (ViolationKind.CHILD, ViolationKind.ATTRIBUTE)
        ):
            span, what, lost = described
            mild = Severity.WARNING if tests.is_tested else Severity.INFO
            harm = LOST if lost else "" if is_group(violation) else tests.harm
            level = None if lost else mild
            fix = rename(manifest, violation.element) if violation.kind is ViolationKind.CHILD else None
            same = too_new[1 : MAX_RELATED + 1] if violation.element in too_new else ()
            related = tuple(Related(manifest.path, each.span, "and here") for each in same)
            yield Hit(manifest.path, span, f"{what}; {harm}".rstrip("; "), level, related=related, fix=fix)


def rename(manifest: Manifest, element: Element) -> Fix | None:
    tag = intended_tag(manifest, element)
    if tag is None:
        return None
    safety = Safety.SAFE if element.tag in RENAMED else Safety.UNSAFE
    return Fix(f"write `<{tag}>`", (rename_element(manifest, element, tag),), safety)


def describe(manifest: Manifest, violation: Violation) -> tuple[Span, str, bool] | None:
    """Return where a violation is, what is wrong, and whether colcon refuses it too; None if other rules report it."""
    element, name = violation.element, violation.name
    match violation.kind:
        case ViolationKind.MISSING:
            return element.open, f"`<{name}>` is missing; add it below `<{before(name)}>`", True
        case ViolationKind.REPEATED:
            return element.span, f"`<{name}>` is here again, and allowed only once; remove one", True
        case ViolationKind.CHILD:
            return element.span, misplaced_tag(manifest, element.tag, element in manifest.root.children), True
        case ViolationKind.ATTRIBUTE:
            span = element.attributes[name].span if name in element.attributes else element.open
            what = f"`<{element.tag}>` has no attribute `{name}` in format {manifest.schema_format}; remove it"
            return span, what, ":" not in name and name != "xmlns"
        case ViolationKind.TEXT:
            return (
                element.open,
                f"`<{element.tag}>` holds text between its elements; remove it or comment it out",
                False,
            )
        case ViolationKind.VALUE if not name and (element.tag, name) not in ELSEWHERE and not empty_group(element):
            return manifest.span(element), *faulty_value(element.tag, element.text)
        case _:
            return None


def empty_group(element: Element) -> bool:
    return element.tag in NEW_IN[3] and not element.text
