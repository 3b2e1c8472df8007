"""DEP002 pip-key."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.depends.dependency_names import DependencyNames
from ...example import Example, manifest
from ...finding import Hit, Severity
from ...rule import Profile, rule


@rule(
    "DEP002",
    "pip-key",
    over=DependencyNames,
    severity=Severity.WARNING,
    profile=Profile.RELEASE,
    examples=(
        Example(
            bad={"package.xml": manifest("  <exec_depend>«python3-ultralytics-pip»</exec_depend>\n")},
            good={"package.xml": manifest()},
        ),
    ),
)
def pip_key(names: DependencyNames) -> Iterator[Hit]:
    """
    ## What it does
    Finds dependencies on rosdep keys that are installed from PyPI on a target.

    ## Why is this bad?
    A package with such a dependency can't be released into a ROS distribution: the build farm makes Debian packages,
    and these depend on Debian packages alone.

    ## When it is quiet
    It runs with `--release` alone: a package that is built from source may take libraries from PyPI. Keys that Ubuntu
    serves on every target are left alone, and so are names of packages of the workspace.

    ## References
    - rosdistro, REVIEW_GUIDELINES.md
    """
    workspace = names.declared.workspace
    for each in names.active():
        if workspace.named(each.name) or not workspace.index.is_pip(each.name, names.targets):
            continue
        message = (
            f"`{each.name}` is installed from PyPI: a package that depends on it can't be released; use a key of "
            f"Ubuntu, or have it packaged"
        )
        yield Hit(names.declared.manifest.path, each.span, message)
