"""The options of `rospkg graph`."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from typer import Argument, Option

from ..arguments import one_of, split
from ..complete import choices, listed
from ..page_on_terminal import refuse_page_on_terminal

EPILOG = (
    "Examples:  rospkg graph src/  ·  rospkg graph --around my_robot_nav --depth 2  ·  "
    "rospkg graph --format html > graph.html"
)
FORMATS = ("list", "dot", "mermaid", "json", "html")
GRAPH_KINDS = ("build", "exec", "test", "launch", "interface")


def graph(
    paths: Annotated[list[Path] | None, Argument(help="Packages, or folders of packages.")] = None,
    format: Annotated[
        str,
        Option(
            "--format",
            metavar="FORMAT",
            autocompletion=choices(*FORMATS),
            help="list, dot, mermaid, json or html: a page to search and filter.",
        ),
    ] = "list",
    around: Annotated[
        str | None, Option(metavar="PACKAGE", help="Only what is near a package, in either direction.")
    ] = None,
    depth: Annotated[int, Option(min=0, metavar="N", help="How many steps away from it.")] = 1,
    kind: Annotated[
        list[str] | None,
        Option(
            metavar="KINDS", autocompletion=listed(lambda: GRAPH_KINDS), help="build, exec, test, launch, interface."
        ),
    ] = None,
    outside: Annotated[bool, Option("--outside", help="Also packages that are not here: rclcpp, …")] = False,
    target: Annotated[
        list[str] | None, Option(metavar="DISTROS", help="humble, jazzy, …: for conditions in package.xml.")
    ] = None,
) -> int:
    """Show which package needs which, what launch files start, and cycles, undeclared and unused dependencies."""
    from .run import GraphOptions
    from .run import graph as show

    one_of("--format", format, FORMATS)
    refuse_page_on_terminal(format, "graph")
    kinds = split(kind)
    for each in kinds:
        one_of("--kind", each, GRAPH_KINDS)
    return show(GraphOptions(tuple(paths or ()), format, around, depth, kinds, outside, split(target)))
