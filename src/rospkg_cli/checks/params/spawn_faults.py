"""PRM003: controllers that are spawned under nearly the name of one that a controller manager has."""

from __future__ import annotations

from collections.abc import Iterator

from ..fault import Fault
from .idle_nodes import level_of
from .launch_parameters import LaunchParameters
from .mistyped_blocks import misspelt_spawns

TYPED = ", unless what the spawner is given has its type"


def spawn_faults(launched: LaunchParameters) -> Iterator[tuple[str, Fault]]:
    """Yield path and fault: an info where nothing adds the spawner, its launch file is not installed, or it may give
    the controller a type.
    """
    for launch, spawned, span, intended, is_typed in misspelt_spawns(launched.files, launched.launches):
        message = f"no controller manager here has a controller `{spawned}`: the spawner ends with an error"
        softer, why = level_of((launch, span, launched.workspace))
        is_mild = softer == "info" or is_typed or launched.is_left_out(launch)
        why = why or TYPED * is_typed
        yield launch.path, Fault(span, f"{message}{why}; did you mean `{intended}`?", "info" if is_mild else None)
