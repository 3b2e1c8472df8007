"""The `<?xml-model?>` line of package.xml, by which ament_xmllint finds the schema."""

from __future__ import annotations

from ..lazy_regex import regex
from .manifest import Manifest

FORMAT_OF_SCHEMA = regex(r"package_format(\d)\.xsd")
SCHEMA_OF_XML = (
    regex(r"""\bhref\s*=\s*["']\s*[^\s"']"""),
    regex(r"""\bschematypens\s*=\s*["']http://www\.w3\.org/2001/XMLSchema["']"""),
)
"""What a `<?xml-model?>` line has that names a schema (ament_xmllint/main.py)."""


def names_schema(manifest: Manifest) -> bool:
    """Return whether the line names an XML schema to ament_xmllint, which reads its `href` and its `schematypens`.

    The schema of another format than the manifest's does not count: what it says of a place may not hold.
    """
    line = manifest.xml_model
    if line is None:
        return False
    other = FORMAT_OF_SCHEMA.search(line.data)
    is_other = other is not None and int(other.group(1)) != manifest.format
    return not is_other and all(pattern.search(line.data) for pattern in SCHEMA_OF_XML)
