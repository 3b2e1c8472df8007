"""The options of `rospkg new`."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

from typer import Argument, Option
from typer.core import TyperCommand

from .. import UsageError
from ..arguments import one_of, split

EPILOG = "Examples:  rospkg new my_robot_nav  ·  rospkg new my_robot_nav --node planner --depends nav_msgs"
WHO, WHAT, WHERE = "Who and what for", "What is in it", "Where"

TYPE = "ament_python, ament_cmake, mixed, interfaces, description or bringup."
NODE = (
    "A node; repeatable. In a mixed package also its language: planner:timer:python. "
    "Of a message: status:publisher:my_msgs/Status. In a bringup package: PACKAGE/EXECUTABLE."
)
FAMILY = "The packages of a robot: NAME_interfaces, NAME_description, NAME and NAME_bringup."
MSG = "A message; repeatable: Status:'float32 battery, string task'."

Names = list[str] | None


class NewCommand(TyperCommand):
    """Lists the kinds of nodes in its help; they are read when that is printed, not whenever rospkg starts."""

    def format_help(self, ctx: Any, formatter: Any) -> None:
        from ...scaffold.node_kinds import listed_kinds

        [node] = [each for each in self.params if "--node" in each.opts]
        node.help = f"{NODE} Kinds: {listed_kinds()}."  # type: ignore[attr-defined]
        super().format_help(ctx, formatter)


def new(
    name: Annotated[str, Argument(help="The name of the package, such as my_robot_nav.", show_default=False)] = "",
    type: Annotated[
        str,
        Option("--type", "-t", "--build-type", metavar="TYPE", help=TYPE, rich_help_panel=WHAT),
    ] = "ament_python",
    node: Annotated[Names, Option(metavar="NAME[:KIND[:LANGUAGE]]", help=NODE, rich_help_panel=WHAT)] = None,
    msg: Annotated[Names, Option(metavar="NAME[:FIELDS]", help=MSG, rich_help_panel=WHAT)] = None,
    srv: Annotated[Names, Option(metavar="NAME[:FIELDS]", help="A service.", rich_help_panel=WHAT)] = None,
    action: Annotated[Names, Option(metavar="NAME[:FIELDS]", help="An action.", rich_help_panel=WHAT)] = None,
    launch: Annotated[
        str,
        Option(
            metavar="FORMAT", help="The launch file: py, xml, yaml or none.", show_default="py", rich_help_panel=WHAT
        ),
    ] = "",
    params: Annotated[
        bool, Option("--params/--no-params", help="A file of parameters for the nodes.", rich_help_panel=WHAT)
    ] = True,
    tests: Annotated[
        str, Option(metavar="TESTS", help="ament, minimal or none.", show_default="ament", rich_help_panel=WHAT)
    ] = "",
    family: Annotated[bool, Option("--family", help=FAMILY, rich_help_panel=WHAT)] = False,
    with_: Annotated[
        Names,
        Option(
            "--with",
            metavar="EXTRAS",
            help="ci, pre-commit, devcontainer, docs (comma-separated).",
            rich_help_panel=WHAT,
        ),
    ] = None,
    template: Annotated[
        str,
        Option(metavar="DIR|GIT-URL", help="A template of your own, instead of --type.", rich_help_panel=WHAT),
    ] = "",
    depends: Annotated[
        Names,
        Option(
            metavar="KEYS", help="Packages and rosdep keys that it depends on (comma-separated).", rich_help_panel=WHAT
        ),
    ] = None,
    distro: Annotated[
        str,
        Option(
            metavar="DISTRO",
            help="The ROS distribution.",
            show_default="$ROS_DISTRO, or the newest LTS",
            rich_help_panel=WHAT,
        ),
    ] = "",
    description: Annotated[str, Option(help="What the package does, in one sentence.", rich_help_panel=WHO)] = "",
    license: Annotated[
        str,
        Option(
            metavar="SPDX", help="The license, as an SPDX identifier.", show_default="Apache-2.0", rich_help_panel=WHO
        ),
    ] = "",
    maintainer: Annotated[
        str, Option(metavar="NAME", help="Name of the maintainer.", show_default="from git", rich_help_panel=WHO)
    ] = "",
    email: Annotated[
        str, Option(help="E-mail address of the maintainer.", show_default="from git", rich_help_panel=WHO)
    ] = "",
    version: Annotated[str, Option(help="MAJOR.MINOR.PATCH.", show_default="0.1.0", rich_help_panel=WHO)] = "",
    year: Annotated[int, Option(help="Year of the copyright.", show_default="this year", rich_help_panel=WHO)] = 0,
    into: Annotated[Path, Option(metavar="DIR", help="The folder to write it into.", rich_help_panel=WHERE)] = Path(),
    dry_run: Annotated[
        bool, Option("--dry-run", help="Show the tree and every file; write nothing.", rich_help_panel=WHERE)
    ] = False,
    diff: Annotated[
        bool,
        Option(
            "--diff",
            help="Show what would change in an existing folder; exit with status 1 if anything would.",
            rich_help_panel=WHERE,
        ),
    ] = False,
    force: Annotated[
        bool,
        Option(
            "--force",
            help="Replace files that differ there; the old ones are kept in NAME.orig.",
            rich_help_panel=WHERE,
        ),
    ] = False,
    skip: Annotated[
        bool, Option("--skip", help="Write only files that are missing there.", rich_help_panel=WHERE)
    ] = False,
    interactive: Annotated[bool, Option("--interactive", "-i", help="Ask for everything that was not given.")] = False,
    color: Annotated[str, Option(metavar="WHEN", help="auto, always or never.")] = "auto",
) -> int:
    """Write a package that builds, runs, and passes its own tests and our linter."""
    from ...scaffold.answers import Request
    from .run import new as write_new

    one_of("--color", color, ("auto", "always", "never"))
    request = Request(
        name=name,
        template=type,
        nodes=split(node),
        depends=split(depends),
        msgs=tuple(msg or ()),
        srvs=tuple(srv or ()),
        actions=tuple(action or ()),
        launch=launch,
        params=params,
        tests=tests,
        extras=split(with_),
        own_template=template,
        description=description,
        license=license,
        maintainer=maintainer,
        email=email,
        version=version,
        distro=distro,
        year=year,
    )
    if template and type != "ament_python":
        raise UsageError("--template replaces --type; leave one of them out")
    if force and skip:
        raise UsageError("--force replaces what --skip leaves alone; choose one of them")
    if interactive:
        from ..streams import say
        from .interactive import ask, command_of
        from .run import defaults

        request = ask(request, into, defaults(into))
        say(f"the same without questions: {command_of(request)}")
    elif not name:
        raise UsageError("a package name is required: `rospkg new my_robot_nav`; `rospkg new -i` asks for everything")
    if family:
        from .family import new_family

        if template:
            raise UsageError("--family writes our own types of packages; leave --template out")
        if with_:
            raise UsageError("--with is for a package that is a repository of its own; leave it out with --family")
        if diff or force or skip:
            raise UsageError(
                "--family writes packages that are not there yet; --diff, --force and --skip require a single package"
            )
        return new_family(request, into, dry_run, color)
    existing = "force" if force else "skip" if skip else ""
    return write_new(request, into, dry_run, color, existing, diff)
