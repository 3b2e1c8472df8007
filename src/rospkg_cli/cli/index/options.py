"""The options of `rospkg index update` and `rospkg index status`."""

from __future__ import annotations

from typing import Annotated

from typer import Option

from ..arguments import one_of, split

HELP = "The index of package names and rosdep keys, fetched from rosdistro, to find unknown names."
EPILOG = "Examples:  rospkg index update  ·  rospkg index status"
UPDATE_EPILOG = "Examples:  rospkg index update  ·  rospkg index update --source ~/rosdistro --distro jazzy,lyrical"
STATUS_EPILOG = "Examples:  rospkg index status  ·  rospkg index status --format json"

SOURCE = "A copy of ros/rosdistro: a folder, or the URL of an index file."
SOURCE_DEFAULT = "$ROSDISTRO_INDEX_URL, `index.source` of your config, or GitHub"


def update(
    source: Annotated[str, Option(metavar="URL|DIR", help=SOURCE, show_default=SOURCE_DEFAULT)] = "",
    distro: Annotated[
        list[str] | None, Option(metavar="DISTROS", help="humble,jazzy,…", show_default="all that are supported")
    ] = None,
    quiet: Annotated[bool, Option("--quiet", "-q", help="Print nothing when there are no problems.")] = False,
) -> int:
    """Fetch the index, with the rosdep lists of this machine; after a failure the old index stays."""
    from .run import update as run

    return run(source, split(distro), quiet)


def status(format: Annotated[str, Option("--format", metavar="FORMAT", help="text or json.")] = "text") -> int:
    """Show where the index is from, how old it is, and how many names it has."""
    from .run import status as run

    one_of("--format", format, ("text", "json"))
    return run(format)
