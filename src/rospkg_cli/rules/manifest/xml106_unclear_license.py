"""XML106 unclear-license."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.manifest.license_files import LicenseFiles
from ...example import Example, manifest
from ...finding import Hit, Severity
from ...ros.license_text import is_prose, licenses_in
from ...rule import rule

CMAKE = manifest(build_type="ament_cmake")
RELEASED = {"tracks.yaml": "tracks: {}\n"}
TWO = CMAKE.replace("<license>Apache-2.0</license>", "<license>BSD-3-Clause</license>\n  <license>MIT</license>")


@rule(
    "XML106",
    "unclear-license",
    over=LicenseFiles,
    severity=Severity.WARNING,
    levels={Severity.INFO: "where nothing shows that the package is released"},
    examples=(
        Example(
            on="ament_cmake",
            bad={"package.xml": CMAKE.replace("Apache-2.0", "«BSD-3-Clause and MIT»"), **RELEASED},
            good={"package.xml": TWO},
        ),
        Example(
            on="ament_cmake",
            bad={"package.xml": CMAKE.replace("Apache-2.0", "«See the LICENSE file»")},
            good={"package.xml": CMAKE},
        ),
    ),
)
def unclear_license(package: LicenseFiles) -> Iterator[Hit]:
    """
    ## What it does
    Finds a `<license>` that names several licenses, or describes one instead of naming it.
    Expressions of SPDX that leave a choice or make an exception (`MIT OR Apache-2.0`, `GPL-2.0-only WITH …`) are left
    alone.

    ## Why is this bad?
    Tools that collect licenses read one name for each tag: they do not know this one, and the package counts as
    unlicensed.

    ## When it is quiet
    Expressions of SPDX that leave a choice or make an exception (`MIT OR Apache-2.0`) are one license, and a name that
    merely differs from SPDX's is left to XML110. Only who releases a package reads the names: where no file of bloom,
    no job and no CHANGELOG.rst of its own shows a release, it is an info.

    ## References
    - [REP-149, license](https://ros.org/reps/rep-0149.html): "only include the license name in this tag. For multiple
      licenses multiple separate tags must be used."
    """
    manifest, level = package.manifest, None if package.release.is_made else Severity.INFO
    for element in manifest.all("license"):
        text = " ".join(element.text.split())
        several = licenses_in(text)
        if len(several) > 1:
            tags = "".join(f"<license>{each}</license>" for each in several)
            message = f"`{text}` names {len(several)} licenses in one tag, which tools read as one; write `{tags}`"
            yield Hit(manifest.path, manifest.span(element), message, level)
        elif is_prose(text):
            shown = text if len(text) < 60 else text[:57] + "…"
            message = f"`{shown}` names no license: tools read a name here, such as `Apache-2.0`; write its SPDX id"
            yield Hit(manifest.path, manifest.span(element), message, level)
