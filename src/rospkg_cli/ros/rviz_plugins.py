"""The kinds of plugins that RViz loads, by the lists of its configs and by the names of well-known ones."""

from __future__ import annotations

from collections.abc import Mapping

LISTS: Mapping[str, str] = {"Panels": "Panel", "Displays": "Display", "Tools": "Tool", "Views": "ViewController"}
"""Where an RViz config lists plugins → the kind of those, which is the last name of their base class."""
PANELS = frozenset({"Docking", "Navigation%202", "Navigation 2", "Selector"})
TOOLS = frozenset({
    "CostmapCostTool", "FocusCamera", "GoalTool", "Interact", "Measure", "MoveCamera", "PublishPoint", "Route%20Tool",
    "Route Tool", "Select", "SetGoal", "SetInitialPose",
})  # fmt: skip
VIEWS = frozenset({"FPS", "FrameAligned", "Orbit", "ThirdPersonFollower", "TopDownOrtho", "XYOrbit"})


def kind_of(name: str) -> str:
    """Return the kind of a well-known plugin of RViz; most are displays."""
    last = name.replace("::", "/").rpartition("/")[2]
    if last in TOOLS:
        return "Tool"
    return "Panel" if last in PANELS else "ViewController" if last in VIEWS else "Display"
