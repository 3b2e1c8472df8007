"""XML109 placeholder-version."""

from __future__ import annotations

from collections.abc import Iterator

from ...example import SETUP_PY, Example, manifest
from ...finding import Hit, Severity
from ...package.manifest import Manifest
from ...rule import Profile, rule

GOOD = manifest()


@rule(
    "XML109",
    "placeholder-version",
    over=Manifest,
    severity=Severity.WARNING,
    profile=Profile.RELEASE,
    examples=(
        Example(
            bad={"package.xml": GOOD.replace("1.0.0", "«0.0.0»"), "setup.py": SETUP_PY.replace("1.0.0", "0.0.0")},
            good={"package.xml": GOOD, "setup.py": SETUP_PY},
        ),
    ),
)
def placeholder_version(manifest: Manifest) -> Iterator[Hit]:
    """
    ## What it does
    Finds the version 0.0.0, which every template begins with.

    ## Why is this bad?
    It can't be released: catkin_prepare_release and bloom increase the version that is there.

    ## When it is quiet
    It runs with `--release` alone: before a release any version will do.
    """
    element = manifest.first("version")
    if element is not None and element.text == "0.0.0":
        message = "the version is still the template's `0.0.0`; give it one before a release, such as `0.1.0`"
        yield Hit(manifest.path, manifest.span(element), message)
