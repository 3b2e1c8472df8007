"""Which targets to link instead of handing a package's name to ament_target_dependencies."""

from __future__ import annotations

from ..lazy_regex import regex
from ..light_dataclasses import dataclass
from .read_table import rows

ROS_NAME = regex(r"[a-z][a-z0-9_]*")
MESSAGES = regex(r".*_(?:msgs|interfaces|srvs|actions)|builtin_interfaces|std_srvs")
INCLUDE = "include:"


@dataclass(frozen=True, slots=True)
class LinkTargets:
    """What to link for one package."""

    targets: tuple[str, ...] = ()
    includes: tuple[str, ...] = ()
    """Include directories that the targets don't carry."""
    certain: bool = True
    """False where it is unknown whether the package exports any targets."""


def link_targets(package: str, exported: tuple[str, ...] = ()) -> LinkTargets:
    """Return what to link for a package that exports some targets (none: unknown).

    ament_target_dependencies took `${name_TARGETS}` where there are any, else the libraries and include directories.
    """
    known = rows("cmake_targets.txt").get(package)
    if known is not None:
        targets = tuple(each for each in known if each != "-" and not each.startswith(INCLUDE))
        return LinkTargets(targets, tuple(each[len(INCLUDE) :] for each in known if each.startswith(INCLUDE)))
    if 0 < len(exported) <= 2:
        return LinkTargets(exported)
    if exported or MESSAGES.fullmatch(package):
        return LinkTargets((f"${{{package}_TARGETS}}",))
    if ROS_NAME.fullmatch(package) and not rows("cmake.txt").get(package):  # a find module of a library sets no targets
        return LinkTargets((f"${{{package}_TARGETS}}",), certain=False)
    return LinkTargets((f"${{{package}_LIBRARIES}}",), (f"${{{package}_INCLUDE_DIRS}}",), certain=False)
