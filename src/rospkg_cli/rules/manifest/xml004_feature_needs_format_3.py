"""XML004 feature-needs-format-3."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.manifest.misplaced_tag import is_of_format_2
from ...checks.manifest.schema_tests import SchemaTests
from ...edits.manifest_format import to_format_3
from ...example import Example, manifest
from ...finding import Fix, Hit, Related, Safety, Severity
from ...languages.xml.elements import Attribute, Element
from ...rule import rule
from ...source import Span

GOOD = manifest('  <exec_depend condition="$ROS_VERSION == 2">rclpy</exec_depend>\n')
BAD = GOOD.replace('format="3"', 'format="2"').replace("format3.xsd", "format2.xsd")


@rule(
    "XML004",
    "feature-needs-format-3",
    over=SchemaTests,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "it is `compatibility`, which colcon ignores, and tests compare package.xml with its schema",
        Severity.INFO: "it is `compatibility`, and no test does that",
    },
    examples=(
        Example(
            bad={"package.xml": BAD.replace('condition="$ROS_VERSION == 2"', '«condition="$ROS_VERSION == 2"»')},
            good={"package.xml": GOOD},
            fix=Safety.SAFE,
        ),
    ),
)
def feature_needs_format_3(tests: SchemaTests) -> Iterator[Hit]:
    """
    ## What it does
    Finds features of format 3 in a manifest of format 1 or 2.
    They are `condition` on a dependency, `group_depend` and `member_of_group`, `compatibility` of a version, `file` of
    a license.

    ## Why is this bad?
    colcon refuses the manifest: it takes the folder for a plain package, without its dependencies. A package with
    interfaces that is `member_of_group` in format 2 is built before what generates its code.

    ## When it is quiet
    In a manifest without a `format`, XML003 reports. `compatibility` of a version, which colcon ignores, is
    a warning where tests compare package.xml with its schema, else an info.

    ## Fix safety
    Format 3 only adds to format 2: nothing else changes its meaning.

    ## References
    - [REP-149](https://ros.org/reps/rep-0149.html)
    """
    manifest = tests.manifest
    if manifest.schema_format == 3 or any(is_of_format_2(manifest, each) for each in manifest.verdict.violations):
        return  # XML001 reports tags of format 2 in a manifest of format 1
    fix = Fix('Write format="3"', to_format_3(manifest))
    mild = [each for each in manifest.features_of_3 if each[1] is not None and each[1].name == "compatibility"]
    for features in ([each for each in manifest.features_of_3 if each not in mild], mild):
        if not features:
            continue
        (element, attribute), *others = features
        what = f"the attribute `{attribute.name}` of `<{element.tag}>`" if attribute else f"`<{element.tag}>`"
        lost = tests.harm if features is mild else "colcon builds the folder as a plain package"
        message = f"{what} came with format 3, and this is format {manifest.schema_format}: {lost}"
        level = (Severity.WARNING if tests.is_tested else Severity.INFO) if features is mild else None
        related = tuple(Related(manifest.path, span_of(*each), "and here") for each in others)
        whole = f'{message}; write `<package format="3">`'
        yield Hit(manifest.path, span_of(element, attribute), whole, level, related, fix)


def span_of(element: Element, attribute: Attribute | None) -> Span:
    return attribute.span if attribute else element.span
