"""WSP004 changelog-mismatch."""

from __future__ import annotations

from collections.abc import Iterator

from ...example import Example, manifest
from ...finding import Hit, Related, Severity
from ...package.changelog import ManifestAndChangelog, number_of
from ...ros.manifest import VERSION
from ...rule import Profile, rule

CHANGES = """\
^^^^^^^^^^^^^^^^^^^^^^^^^^^^
Changelog for package my_pkg
^^^^^^^^^^^^^^^^^^^^^^^^^^^^

Forthcoming
-----------
* Drives backwards

«1.1.0» (2026-02-01)
------------------
* Drives
"""


@rule(
    "WSP004",
    "changelog-mismatch",
    over=ManifestAndChangelog,
    severity=Severity.WARNING,
    profile=Profile.RELEASE,
    examples=(
        Example(
            bad={"CHANGELOG.rst": CHANGES},
            good={"CHANGELOG.rst": CHANGES.replace("«1.1.0»", "1.0.0")},
        ),
        Example(
            bad={
                "CHANGELOG.rst": CHANGES.replace("«1.1.0»", "0.9.0"),
                "package.xml": manifest().replace("1.0.0", "«1.0.0»"),
            },
            good={"CHANGELOG.rst": CHANGES.replace("«1.1.0»", "1.0.0")},
        ),
    ),
)
def changelog_mismatch(released: ManifestAndChangelog) -> Iterator[Hit]:
    """
    ## What it does
    Compares the version in package.xml with the newest entry of CHANGELOG.rst.

    ## Why is this bad?
    bloom stops where the changelog has an entry for a newer version than the one that is released. Where it has none
    for that version, the release notes say "no changelog for this version found".

    ## When it is quiet
    Only titles of the form `1.2.3 (2026-01-31)` are entries; `Forthcoming` is none. A package without a changelog, or
    with none that has an entry, is left alone.

    ## References
    [REP-132](https://ros.org/reps/rep-0132.html)
    """
    manifest, newest = released.manifest, released.changelog.newest
    if newest is None or not VERSION.fullmatch(manifest.version) or newest.version == manifest.version:
        return
    path, version = released.changelog.source.path, manifest.version
    if newest.number > number_of(version):
        message = (
            f"the changelog has an entry for `{newest.version}`, package.xml is at `{version}`: bloom won't release "
            f"it; write `{newest.version}` into package.xml, or call this entry `Forthcoming`"
        )
        related = (Related(manifest.path, manifest.version_span, f"`{version}` here"),)
        yield Hit(path, newest.span, message, related=related)
    elif all(entry.version != version for entry in released.changelog.entries):
        message = (
            f"{path} has no entry for `{version}`, its newest is `{newest.version}`: bloom releases it without notes; "
            f"write one (`catkin_generate_changelog`, or rename `Forthcoming`)"
        )
        related = (Related(path, newest.span, "the newest entry"),)
        yield Hit(manifest.path, manifest.version_span, message, related=related)
