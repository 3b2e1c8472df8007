"""XML003 unsupported-format."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.manifest.schema_tests import SchemaTests
from ...edits.manifest_format import to_format_3
from ...edits.manifest_tags import set_attribute
from ...example import Example, manifest
from ...finding import Fix, Hit, Safety, Severity
from ...ros.manifest import FORMATS, NEW_IN
from ...rule import rule

GOOD = manifest("  <exec_depend>rclpy</exec_depend>\n")


@rule(
    "XML003",
    "unsupported-format",
    over=SchemaTests,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "no format is named and tags of format 2 or 3 are used, or spaces are around it and tests "
        "compare package.xml with its schema",
        Severity.INFO: "there are spaces around it, and no test does that",
    },
    examples=(
        Example(
            bad={"package.xml": GOOD.replace('format="3"', 'format="«4»"')},
            good={"package.xml": GOOD},
            fix=Safety.SAFE,
        ),
        Example(
            bad={"package.xml": GOOD.replace('<package format="3">', "«<package>»")},
            good={"package.xml": GOOD},
            fix=Safety.SAFE,
        ),
    ),
)
def unsupported_format(tests: SchemaTests) -> Iterator[Hit]:
    """
    ## What it does
    Finds a `format` other than 1, 2 and 3, and tags of format 2 or 3 without a `format`.
    A `<package>` without one is format 1.

    ## Why is this bad?
    colcon can't read the manifest: it takes the folder for a plain package, forgets its dependencies, and `ros2 run`
    does not find it.

    ## When it is quiet
    A manifest without a format that uses only what format 1 has is left alone, and so is `<run_depend>` in it.

    ## References
    - [REP-149, package](https://ros.org/reps/rep-0149.html#package-format-3)
    """
    manifest = tests.manifest
    fix = Fix('Write format="3"', to_format_3(manifest))
    declared = manifest.declared_format
    if declared is not None and manifest.format not in FORMATS:
        message = (
            f"there is no format `{declared.value}` of package.xml: colcon builds the folder as a plain "
            f'package; write `format="3"`'
        )
        yield Hit(manifest.path, declared.value_span if declared.value else declared.span, message, fix=fix)
    elif declared is not None and declared.value != str(manifest.format):
        message = f'the format is written `{declared.value}`: {tests.harm}; write `format="{manifest.format}"`'
        level = Severity.WARNING if tests.is_tested else Severity.INFO
        edit = set_attribute(manifest, manifest.root, "format", str(manifest.format))
        yield Hit(manifest.path, declared.value_span, message, level, fix=Fix("Write it plainly", (edit,)))
    newer = manifest.all(*(tag for tags in NEW_IN.values() for tag in tags))
    if declared is None and newer:
        message = (
            f"`<package>` names no format, so it is format 1, which has no `<{newer[0].tag}>`: colcon builds "
            f'the folder as a plain package; write `<package format="3">`'
        )
        yield Hit(manifest.path, manifest.root.open, message, Severity.WARNING, fix=fix)
