"""The options of `rospkg index update` and `rospkg index status`."""

from __future__ import annotations

from typing import Annotated

from typer import Option

from ..arguments import one_of, split

HELP = "The names of packages and rosdep keys: fetched from rosdistro, so that unknown ones can be told."
EPILOG = "Examples:  rospkg index update  ·  rospkg index status"
UPDATE_EPILOG = "Examples:  rospkg index update  ·  rospkg index update --source ~/rosdistro --distro jazzy,lyrical"
STATUS_EPILOG = "Examples:  rospkg index status  ·  rospkg index status --format json"

SOURCE = (
    "A copy of ros/rosdistro: a folder, or the URL of an index file; else $ROSDISTRO_INDEX_URL, else `index.source` of "
    "your config, else the one on GitHub."
)


def update(
    source: Annotated[str, Option(metavar="URL|DIR", help=SOURCE)] = "",
    distro: Annotated[
        list[str] | None, Option(metavar="DISTROS", help="humble,jazzy,… (else all that are supported).")
    ] = None,
    quiet: Annotated[bool, Option("--quiet", "-q", help="Say nothing where nothing is wrong.")] = False,
) -> int:
    """Fetch the names, with those of rosdep's lists on this machine; on any failure the old ones stay."""
    from .run import update as run

    return run(source, split(distro), quiet)


def status(format: Annotated[str, Option("--format", metavar="FORMAT", help="text or json.")] = "text") -> int:
    """Where the names are from, how old they are, and how many there are."""
    from .run import status as run

    one_of("--format", format, ("text", "json"))
    return run(format)
