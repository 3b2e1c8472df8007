"""Whether anything notices what only the schema of package.xml forbids."""

from __future__ import annotations

from ...package.manifest import Manifest

CHECKERS = ("ament_lint_common", "ament_cmake_xmllint", "ament_xmllint")
"""What brings ament_xmllint into a package's tests."""


def is_schema_tested(manifest: Manifest) -> bool:
    """Return whether the package's tests compare package.xml with its schema.

    ament_xmllint checks the schema that an `<?xml-model …?>` line names, and without one only that the file is
    well-formed (ament_xmllint/main.py).
    """
    return manifest.names_schema and any(manifest.depends_on(name) for name in CHECKERS)


def schema_harm(manifest: Manifest) -> str:
    """Return what happens because the schema refuses something that colcon takes, as a clause."""
    if is_schema_tested(manifest):
        return "`colcon test` fails, since it runs ament_xmllint"
    if manifest.names_schema:
        return "ament_xmllint and editors that know the schema refuse it"
    return "no tool checks it while no `<?xml-model?>` line names the schema"
