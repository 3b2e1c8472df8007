"""Whether it is open how a package is built, so that nothing may be concluded from what a build would make."""

from __future__ import annotations

from ..files import PackageFiles
from ..languages.rep149_condition import can_hold_together
from ..ros.distros import Targets
from ..ros.manifest import BUILD_FILES
from .manifest import Manifest


def is_build_type_contested(manifest: Manifest, files: PackageFiles, targets: Targets) -> bool:
    """Return whether two build types hold at once, or the file that one of them is built by is missing."""
    wanted = (BUILD_FILES.get(each.text) for each in manifest.build_types(targets))
    return has_several_build_types(manifest, targets) or any(path and not files.exists(path) for path in wanted)


def has_several_build_types(manifest: Manifest, targets: Targets) -> bool:
    """Return whether two of the build types hold at once."""
    found, environments = [each.get("condition") for each in manifest.build_types(targets)], targets.environments()
    pairs = ((one, other) for index, one in enumerate(found) for other in found[:index])
    return any(can_hold_together(one, other, environments) for one, other in pairs)
