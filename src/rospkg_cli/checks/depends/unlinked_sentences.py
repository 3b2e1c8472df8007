"""What CMK121 says of a package that a target is not linked with and that nothing brings in every distribution."""

from __future__ import annotations

from ..repository.older_distribution import OlderDistribution
from .unlinked_includes import UnlinkedInclude

ON_DEMAND = "; it is built on demand alone"


def lacking(each: UnlinkedInclude, distribution: OlderDistribution) -> str:
    ends = 'the build ends with "No such file or directory"'
    if each.keeper:
        ends = f"up to Humble `{each.keeper}` brings it, from Jazzy on the build stops"
    elif distribution.is_before_humble and each.is_own_folder:
        ends = "from Humble on the build stops, as each package has a folder of headers of its own"
    elif not each.is_own_folder:
        ends = "it builds only where the headers lie in a folder that others share"
    start = f"`{each.header}` is included here, and `{each.target.name}` is not linked with `{each.package}`"
    find = "" if each.is_found else "find it, and "
    end = ON_DEMAND if each.is_on_demand else "" if each.behind is None else each.behind.sentence
    return f"{start}: {ends}; {find}add it to `target_link_libraries({each.target.name} …)`{end}"


def is_met(each: UnlinkedInclude, distribution: OlderDistribution) -> bool:
    """Return whether a build of a distribution of the repository stops for it, and not before at a source of ROS 1."""
    is_shared = distribution.is_before_humble and each.is_own_folder
    is_later = is_shared or (bool(each.keeper) and not distribution.reaches_jazzy)
    return (each.is_own_folder or bool(each.keeper)) and not is_later and each.behind is None and not each.is_on_demand
