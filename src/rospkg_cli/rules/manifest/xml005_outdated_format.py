"""XML005 outdated-format."""

from __future__ import annotations

from collections.abc import Iterator

from ...edits.manifest_format import to_format_3
from ...example import Example, manifest
from ...finding import Fix, Hit, Safety, Severity
from ...package.manifest import Manifest
from ...rule import Profile, rule

GOOD = manifest("  <exec_depend>rclpy</exec_depend>\n")
BAD = GOOD.replace('format="3"', 'format="«2»"').replace("format3.xsd", "format2.xsd")
ONE = manifest(
    "  <build_depend>rclpy</build_depend>\n  <run_depend>rcl</run_depend>\n  <run_depend>rclpy</run_depend>\n"
)
ONE_AS_3 = manifest(
    "  <build_export_depend>rcl</build_export_depend>\n  <exec_depend>rcl</exec_depend>\n  <depend>rclpy</depend>\n"
)


@rule(
    "XML005",
    "outdated-format",
    over=Manifest,
    severity=Severity.INFO,
    profile=Profile.PEDANTIC,
    examples=(
        Example(bad={"package.xml": BAD}, good={"package.xml": GOOD}, fix=Safety.SAFE),
        Example(
            bad={
                "package.xml": ONE.replace('<package format="3">', "«<package>»").replace("format3.xsd", "format1.xsd")
            },
            good={"package.xml": ONE_AS_3},
            fix=Safety.SAFE,
        ),
    ),
)
def outdated_format(manifest: Manifest) -> Iterator[Hit]:
    """
    ## What it does
    Finds a manifest of format 1 or 2.
    The fix makes it one of format 3: `run_depend` becomes `depend` where there is a `build_depend` of the same name,
    else `build_export_depend` and `exec_depend`.

    ## Why is this bad?
    It is not wrong: every tool reads the old formats. Conditions, groups and the files of licenses need format 3.

    ## When it is quiet
    It runs with `--pedantic` alone. Manifests that use features of format 3 already are left to XML004.

    ## References
    - [REP-140, Removing run_depend](https://ros.org/reps/rep-0140.html), [REP-149](https://ros.org/reps/rep-0149.html)
    """
    if manifest.schema_format == 3 or manifest.features_of_3:
        return
    declared = manifest.declared_format
    fix = Fix("Make it a manifest of format 3", to_format_3(manifest))
    message = f'this is format {manifest.schema_format}; the newest is 3: write `<package format="3">`'
    yield Hit(manifest.path, declared.value_span if declared else manifest.root.open, message, fix=fix)
