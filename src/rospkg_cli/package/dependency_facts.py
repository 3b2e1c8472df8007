"""The dependencies and groups of a manifest, as fields of PackageFacts."""

from __future__ import annotations

from ..languages.rep149_condition import always_holds, may_hold
from ..ros.distros import Targets
from .manifest import Manifest
from .package_facts import ActiveDependency


def dependencies(manifest: Manifest, targets: Targets) -> tuple[ActiveDependency, ...]:
    """Return the dependencies that hold, or may hold, for one of the targets."""
    environments = targets.environments()
    return tuple(
        ActiveDependency(each.tag, each.name, each.span, always_holds(each.condition, environments))
        for each in manifest.dependencies
        if each.active(targets)
    )


def groups(manifest: Manifest, targets: Targets) -> frozenset[str]:
    """Return the groups that a package is a member of, whatever the target."""
    environments = targets.environments()
    members = manifest.all("member_of_group")
    return frozenset(each.text for each in members if always_holds(each.get("condition"), environments))


def group_dependencies(manifest: Manifest, targets: Targets) -> tuple[ActiveDependency, ...]:
    environments = targets.environments()
    return tuple(
        ActiveDependency(each.tag, each.text, manifest.span(each), always_holds(each.get("condition"), environments))
        for each in manifest.all("group_depend")
        if may_hold(each.get("condition"), environments)
    )
