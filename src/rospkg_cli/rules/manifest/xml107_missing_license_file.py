"""XML107 missing-license-file."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from ...checks.manifest.license_files import LicenseFiles
from ...example import Example, manifest
from ...finding import Hit, Severity
from ...rule import rule
from ...suggest import did_you_mean

GOOD = manifest().replace("<license>", '<license file="LICENSE">')
CHANGES = """\
Changelog for package my_pkg
============================

1.0.0 (2026-01-02)
------------------
* Drive.
"""


@rule(
    "XML107",
    "missing-license-file",
    over=LicenseFiles,
    severity=Severity.ERROR,
    levels={Severity.INFO: "where nothing shows that the package is released"},
    examples=(
        Example(
            bad={"package.xml": GOOD.replace('"LICENSE"', '"«LICENCE»"'), "CHANGELOG.rst": CHANGES},
            good={"package.xml": GOOD},
        ),
        Example(
            bad={"package.xml": GOOD.replace('"LICENSE"', '"«../LICENSE»"'), "CHANGELOG.rst": CHANGES},
            good={"package.xml": GOOD},
        ),
    ),
)
def missing_license_file(package: LicenseFiles) -> Iterator[Hit]:
    """
    ## What it does
    Finds a license whose `file` does not exist, is an absolute path, or is outside of the package.

    ## Why is this bad?
    bloom refuses to release the package: it packs the package's folder, and the license text is not in it.

    ## When it is quiet
    Only a `file` attribute in format 3 is judged: it may name any file of the package. Packages without the attribute
    are left to XML111. It is an info where nothing shows that the package is released: no file of bloom, no job for it,
    and no CHANGELOG.rst of its own.

    ## References
    - [REP-149, license](https://ros.org/reps/rep-0149.html): "A path relative to the package.xml file"
    """
    manifest = package.manifest
    for element in manifest.all("license"):
        attribute = element.attributes.get("file")
        if attribute is None or manifest.schema_format < 3:
            continue
        path = posixpath.normpath(attribute.value.strip())
        if not attribute.value.strip():
            why = "`file` names no file; name the license text, or remove the attribute"
        elif path.startswith(("/", "..")):
            why = f"`{attribute.value}` is outside of the package, and is not released with it; copy it in"
        elif package.files.exists(path):
            continue
        else:
            near = did_you_mean(path, package.files.paths)
            why = f"`{attribute.value}` does not exist{near}: bloom refuses to release it; add the license text"
        level = None if package.release.is_made else Severity.INFO
        yield Hit(manifest.path, attribute.value_span if attribute.value else attribute.span, why, level)
