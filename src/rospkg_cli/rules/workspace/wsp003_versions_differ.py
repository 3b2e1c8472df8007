"""WSP003 versions-differ."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.workspace.version_mismatches import version_mismatches
from ...example import Example, manifest
from ...finding import Hit, Related, Severity
from ...package.workspace import Workspace
from ...rule import Profile, rule


@rule(
    "WSP003",
    "versions-differ",
    over=Workspace,
    severity=Severity.WARNING,
    profile=Profile.RELEASE,
    examples=(
        Example(
            on="",
            bad={
                ".github/workflows/build.yml": "on: push\n",
                "arm/package.xml": manifest("", "cmake", "arm"),
                "hand/package.xml": manifest("", "cmake", "hand"),
                "foot/package.xml": manifest("", "cmake", "foot").replace("1.0.0", "«0.1.0»"),
            },
            good={"foot/package.xml": manifest("", "cmake", "foot")},
        ),
    ),
)
def versions_differ(workspace: Workspace) -> Iterator[Hit]:
    """
    ## What it does
    Finds packages whose version differs from that of most packages of their repository.
    A repository is the folder with the nearest `.git` (or `.github`, `.gitlab-ci.yml` and the like) above them;
    packages outside of one are left alone.

    ## Why is this bad?
    All packages of a repository are released together: bloom stops with "Two packages have different version numbers".

    ## When it is quiet
    Packages outside of a repository, and repositories with no common version, are left alone.
    """
    for each in version_mismatches(workspace):
        facts, count = each.package, len(each.others)
        if facts.folder in workspace.selected:
            whose = f"`{each.others[0].name}` has" if count == 1 else f"{count} packages of this repository have"
            message = (
                f"`{facts.name}` is at `{facts.version}`, and {whose} `{each.common}`: bloom stops where versions "
                f"differ; write `{each.common}` here too"
            )
            other = each.others[0]
            related = (Related(other.at("package.xml"), other.version_span, f"`{each.common}` here"),)
            yield Hit(facts.at("package.xml"), facts.version_span, message, related=related)
