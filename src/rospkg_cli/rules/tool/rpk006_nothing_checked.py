"""RPK006 nothing-checked."""

from __future__ import annotations

from collections.abc import Iterator

from ...example import Example, manifest
from ...finding import Hit, Severity
from ...package.run_events import NoPackagesFound
from ...rule import rule
from ...source import Span


@rule(
    "RPK006",
    "nothing-checked",
    over=NoPackagesFound,
    severity=Severity.ERROR,
    examples=(Example(on="", bad={"README.md": "A workspace\n"}, good={"package.xml": manifest()}),),
)
def nothing_checked(nothing: NoPackagesFound) -> Iterator[Hit]:
    """
    ## What it does
    Reports that no package was found under the given paths.
    There is no folder with a package.xml that isn't hidden by COLCON_IGNORE, AMENT_IGNORE or CATKIN_IGNORE. What colcon
    made, below `build/` and `install/`, does not count, nor does what lies in a folder whose name begins with a dot:
    colcon does not look there.

    ## Why is this bad?
    A run that checked nothing is not a green run. Where that is intended, as in a hook, use `--allow-empty`.

    ## When it is quiet
    With `--allow-empty` an empty run is green.
    """
    names = ", ".join(f"`{path}`" for path in nothing.paths) or "`.`"
    why = nothing.hidden or "no package.xml was found"
    message = f"there is no package under {names}: {why}; give the path of a package or a workspace"
    yield Hit(nothing.place, Span(0, 0), message)
