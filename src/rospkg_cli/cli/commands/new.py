"""The options of `rospkg new`."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from typer import Argument, Option

from . import one_of, split

EPILOG = "Examples:  rospkg new my_robot_nav  ·  rospkg new my_robot_nav --node planner --depends nav_msgs"
WHO, WHAT, WHERE = "Who and what for", "What is in it", "Where"

Names = list[str] | None


def new(
    name: Annotated[str, Argument(help="The name of the package, such as my_robot_nav.")],
    type: Annotated[
        str, Option("--type", "-t", "--build-type", metavar="TYPE", help="ament_python.", rich_help_panel=WHAT)
    ] = "ament_python",
    node: Annotated[Names, Option(metavar="NAME", help="A node; repeatable.", rich_help_panel=WHAT)] = None,
    depends: Annotated[
        Names, Option(metavar="KEYS", help="Packages and rosdep keys that it uses.", rich_help_panel=WHAT)
    ] = None,
    distro: Annotated[
        str, Option(metavar="DISTRO", help="Else $ROS_DISTRO, else the newest LTS.", rich_help_panel=WHAT)
    ] = "",
    description: Annotated[str, Option(help="In one sentence.", rich_help_panel=WHO)] = "",
    license: Annotated[str, Option(metavar="SPDX", help="Else Apache-2.0.", rich_help_panel=WHO)] = "",
    maintainer: Annotated[str, Option(metavar="NAME", help="Else git's.", rich_help_panel=WHO)] = "",
    email: Annotated[str, Option(help="Else git's.", rich_help_panel=WHO)] = "",
    version: Annotated[str, Option(help="MAJOR.MINOR.PATCH.", rich_help_panel=WHO)] = "",
    into: Annotated[Path, Option(metavar="DIR", help="The folder to put it in.", rich_help_panel=WHERE)] = Path(),
    dry_run: Annotated[
        bool, Option("--dry-run", help="Show the tree and every file; write nothing.", rich_help_panel=WHERE)
    ] = False,
    color: Annotated[str, Option(metavar="WHEN", help="auto, always or never.")] = "auto",
) -> int:
    """Write a package that builds, runs, and passes its own tests and our linter."""
    from ...scaffold.answers import Request
    from ..new import new as write_new

    one_of("--color", color, ("auto", "always", "never"))
    request = Request(
        name=name,
        template=type,
        nodes=split(node),
        depends=split(depends),
        description=description,
        license=license,
        maintainer=maintainer,
        email=email,
        version=version,
        distro=distro,
    )
    return write_new(request, into, dry_run, color)
