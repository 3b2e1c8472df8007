"""SET208 wrong-data-destination."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.setup.data_destinations import DataDestinations
from ...edits.data_files import replace_destination
from ...example import Example, setup_py
from ...finding import Fix, Hit, Safety, Severity
from ...rule import rule

ENTRY = "        ('share/' + package_name, ['package.xml']),\n"
LAUNCH = {"launch/robot.launch.xml": "<launch>\n</launch>\n"}


def installed(destination: str) -> str:
    return setup_py().replace(ENTRY, f"{ENTRY}        ('{destination}', ['launch/robot.launch.xml']),\n")


GOOD = installed("share/my_pkg/launch")


@rule(
    "SET208",
    "wrong-data-destination",
    over=DataDestinations,
    severity=Severity.WARNING,
    levels={
        Severity.ERROR: "it begins with a slash: colcon stops; or a launch file includes what goes there",
        Severity.INFO: "nothing here opens its files, or another entry installs them in the right place",
    },
    examples=tuple(
        Example(bad={**LAUNCH, "setup.py": installed(f"«{place}»")}, good={"setup.py": GOOD}, fix=Safety.SAFE)
        for place in ("share/your_pkg/launch", "share/launch", "launch", "shre/my_pkg/launch", "/share/my_pkg/launch")
    ),
)
def wrong_data_destination(destinations: DataDestinations) -> Iterator[Hit]:
    """
    ## What it does
    Finds destinations in `data_files` that ROS tools do not search.
    It is the share folder of another package, `share/launch` without the package, a folder right below the prefix, a
    mistyped `share`, or a path that begins with a slash.

    ## Why is this bad?
    `get_package_share_directory('my_pkg')` and `ros2 launch my_pkg` look below `share/my_pkg`. A destination in another
    package's folder is usually left over from a copied setup.py, and overwrites that package's files.

    ## When it is quiet
    In folders of share/ that belong to no package, such as `share/applications`, and for destinations that can't be
    evaluated. Of files other than launch files and package.xml it is an info where nothing in the workspace opens them
    in the package's share directory.
    """
    for entry, right, why in destinations.misplaced:
        assert entry.destination is not None
        package = destinations.shared.package
        edits = replace_destination(package.setup, package.name, entry.destination, right)
        fix = Fix(f"install into {right}", edits) if edits else None
        stops = None if entry.destination.text.startswith("/") else destinations.included(entry)
        is_fatal = stops or entry.destination.text.startswith("/")
        unmet = "" if is_fatal else destinations.why_unmet(entry)
        level = Severity.ERROR if is_fatal else Severity.INFO if unmet else None
        harm = f", so that `{stops[0]}` stops at `{stops[1]}`" if stops else ""
        message = f"`{entry.destination.text}` {why}{harm}; write `{right}`{'; ' if unmet else ''}{unmet}"
        yield Hit(entry.path, entry.destination.shown, message, level=level, fix=fix)
