"""XML111 no-license-text."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...checks.manifest.manifest_inputs import ManifestAndFiles
from ...example import Example, manifest
from ...finding import Hit, Severity
from ...lazy_regex import regex
from ...ros.licenses import spdx_id
from ...rule import Profile, rule

TEXT = regex(r"(LICEN[CS]E|COPYING)([._-][^/]*)?|LICENSES/.+", re.IGNORECASE)
USUAL = tuple(
    name + end
    for name in ("LICENSE", "LICENCE", "COPYING", "license", "License")
    for end in ("", ".txt", ".md", ".rst")
)
MANIFEST = manifest()


@rule(
    "XML111",
    "no-license-text",
    over=ManifestAndFiles,
    severity=Severity.WARNING,
    profile=Profile.RELEASE,
    examples=(
        Example(
            bad={"LICENSE": None, "package.xml": MANIFEST.replace("Apache-2.0", "«Apache-2.0»")},
            good={"LICENSE": "Apache License\n"},
        ),
    ),
)
def no_license_text(package: ManifestAndFiles) -> Iterator[Hit]:
    """
    ## What it does
    Finds packages without a license text in their folder or in one above.
    It is LICENSE, LICENCE, COPYING or a folder LICENSES, in the package or in a folder above it, up to the root of the
    run.

    ## Why is this bad?
    Most licenses require their text to be distributed with the software. The review for a ROS distribution asks for it.

    ## When it is quiet
    It runs with `--release` alone. A text in the package, or in a folder above it, is enough under any usual name; a
    `file` attribute is left to XML107.

    ## References
    - [REP-149, license](https://ros.org/reps/rep-0149.html): "Many licenses require including the license text"
    """
    manifest, files = package.manifest, package.files
    licenses = manifest.all("license")
    if not licenses or any("file" in each.attributes for each in licenses):
        return
    by_id = [f"LICENSES/{spdx_id(each.text)}.txt" for each in licenses]
    if any(TEXT.fullmatch(path) for path in files.paths) or files.above((*USUAL, *by_id)):
        return
    message = "no license text is in the package or in a folder above it; a release is refused without: add `LICENSE`"
    yield Hit(manifest.path, manifest.span(licenses[0]), message)
