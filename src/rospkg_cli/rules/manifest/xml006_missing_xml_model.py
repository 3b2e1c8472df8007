"""XML006 missing-xml-model."""

from __future__ import annotations

from collections.abc import Iterator

from ...edits.manifest_format import add_schema_line, schema_line
from ...example import Example, manifest
from ...finding import Fix, Hit, Safety, Severity
from ...package.manifest import Manifest
from ...ros.manifest import XML_MODEL
from ...rule import Profile, rule

GOOD = manifest()


@rule(
    "XML006",
    "missing-xml-model",
    over=Manifest,
    severity=Severity.WARNING,
    profile=Profile.PEDANTIC,
    examples=(
        Example(
            bad={
                "package.xml": GOOD.replace(XML_MODEL.format(3) + "\n", "").replace(
                    '<package format="3">', '«<package format="3">»'
                )
            },
            good={"package.xml": GOOD},
            fix=Safety.SAFE,
        ),
        Example(
            bad={"package.xml": GOOD.replace(XML_MODEL.format(3), f"«{XML_MODEL.format(2)}»")},
            good={"package.xml": GOOD},
            fix=Safety.SAFE,
        ),
    ),
)
def missing_xml_model(manifest: Manifest) -> Iterator[Hit]:
    """
    ## What it does
    Finds a package.xml without the `<?xml-model …?>` line of its format, which names the schema.

    ## Why is this bad?
    Without the line colcon says nothing when it can't read the manifest (with it there is a warning), and
    `ament_xmllint` and editors check nothing. With the schema of another format they complain about what is right.

    ## When it is quiet
    It runs with `--pedantic` alone. A line that names the schema of the package's format is enough, wherever that
    schema lies.

    ## References
    - [REP-149, Schema](https://ros.org/reps/rep-0149.html#schema)
    """
    format, line = manifest.schema_format, manifest.xml_model
    if line is None:
        message = (
            "no `<?xml-model …?>` line names the schema: if this file breaks, colcon will not even warn; add "
            f"`{XML_MODEL.format(format)}` below the first line"
        )
        fix = Fix("Name the schema", (add_schema_line(manifest, format),))
        yield Hit(manifest.path, manifest.root.open, message, fix=fix)
    elif edits := schema_line(manifest, str(format)):
        message = (
            f"this line names the schema of another format; the package is of format {format}: ament_xmllint fails"
        )
        yield Hit(manifest.path, line.span, message, fix=Fix(f"Name the schema of format {format}", edits))
