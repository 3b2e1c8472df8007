"""The options of `rospkg new`."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

from typer import Argument, Option
from typer.core import TyperCommand

from .. import UsageError
from ..arguments import one_of, split
from ..complete import (
    Completion,
    choices,
    dependency_names,
    distro_names,
    license_names,
    listed,
    node_kinds,
    plugin_words,
)

if TYPE_CHECKING:
    pass

EPILOG = "Examples:  rospkg new my_robot_nav  ·  rospkg new my_robot_nav --node planner --depends nav_msgs"
WHO, WHAT, WHERE = "Who and what for", "What is in it", "Where"

TYPES = (
    "ament_python",
    "ament_cmake",
    "mixed",
    "library",
    "plugin",
    "interfaces",
    "description",
    "bringup",
    "workspace",
)
TYPE = f"{', '.join(TYPES[:-1])} or {TYPES[-1]}."
NODE = (
    "A node; repeatable. In a mixed package also its language: planner:timer:python. "
    "About an interface: go:service:my_msgs/Go, with topic: scan:subscriber:sensor_msgs/LaserScan@/scan. "
    "In a bringup package: PACKAGE/EXECUTABLE."
)
PLUGIN = "A plugin, as KIND or NAME:KIND; repeatable. Its package is of --type plugin."
MINIMAL = "No README, .gitignore, CONTRIBUTING.md, file of parameters; tests that need no ROS."
PARAMS = (
    "file: config/params.yaml; generate: also definitions that generate_parameter_library declares them from; none."
)
FAMILY = "The packages of a robot: NAME_interfaces, NAME_description, NAME and NAME_bringup."
MSG = "A message; repeatable: Status:'float32 battery, string task'."

WITH = "ci, pre-commit, devcontainer, docs (comma-separated), or none."
DEPENDS = "Packages and rosdep keys that it depends on (comma-separated)."
DISTRO = "$ROS_DISTRO, or the newest LTS"
DIFF = "Show what would change in an existing folder; exit with status 1 if anything would."
UPDATE = "Merge what would be written today, with the other options, into a package or workspace that was written so."
RECORD = "Keep the answers in the package, for --update."
FORCE = "Replace files that differ there; the old ones are kept in NAME.orig."

MAINTAINER, EMAIL = ("--maintainer", "--maintainer-name"), ("--email", "--maintainer-email")
INTO = ("--into", "--destination-directory")
LAUNCH, TESTS = choices("py", "xml", "yaml", "none"), choices("ament", "minimal", "none")
EXTRAS, KEYS = listed(lambda: ("ci", "pre-commit", "devcontainer", "docs")), listed(dependency_names)
DISTROS, LICENSES = listed(distro_names), listed(license_names)

Names = list[str] | None


def option(
    panel: str,
    help: str,
    *names: str,
    metavar: str | None = None,
    default: str | bool = True,
    values: Completion | None = None,
) -> Any:
    """Return an option in one part of the help; `default` is shown where an empty value means something."""
    return Option(
        *names, metavar=metavar, help=help, show_default=default, rich_help_panel=panel, autocompletion=values
    )


who, what, where = partial(option, WHO), partial(option, WHAT), partial(option, WHERE)


class NewCommand(TyperCommand):
    """Lists the kinds of nodes in its help; they are read when that is printed, not whenever rospkg starts."""

    def format_help(self, ctx: Any, formatter: Any) -> None:
        from ...scaffold.node_kinds import listed_kinds
        from ...scaffold.plugin_kinds import plugin_kinds

        kinds = {"--node": (NODE, listed_kinds()), "--plugin": (PLUGIN, ", ".join(plugin_kinds()))}
        for each, name in ((each, name) for each in self.params for name in kinds if name in each.opts):
            each.help = "{} Kinds: {}.".format(*kinds[name])  # type: ignore[attr-defined]
        super().format_help(ctx, formatter)


def new(
    name: Annotated[str, Argument(help="Its name, or a path that ends in it: my_robot_nav, src/my_robot_nav, .")] = "",
    type: Annotated[
        str, what(TYPE, "--type", "-t", "--build-type", metavar="TYPE", values=choices(*TYPES))
    ] = "ament_python",
    node: Annotated[
        Names, what(NODE, "--node", "--node-name", metavar="NAME[:KIND[:LANGUAGE]]", values=node_kinds)
    ] = None,
    plugin: Annotated[Names, what(PLUGIN, "--plugin", metavar="[NAME:]KIND", values=plugin_words)] = None,
    msg: Annotated[Names, what(MSG, metavar="NAME[:FIELDS]")] = None,
    srv: Annotated[Names, what("A service.", metavar="NAME[:FIELDS]")] = None,
    action: Annotated[Names, what("An action.", metavar="NAME[:FIELDS]")] = None,
    launch: Annotated[
        str, what("The launch file: py, xml, yaml or none.", metavar="FORMAT", default="py", values=LAUNCH)
    ] = "",
    params: Annotated[
        str, what(PARAMS, "--params", metavar="FORM", default="file", values=choices("file", "generate", "none"))
    ] = "",
    no_params: Annotated[bool, what("The same as --params none.", "--no-params")] = False,
    tests: Annotated[str, what("ament, minimal or none.", metavar="TESTS", default="ament", values=TESTS)] = "",
    minimal: Annotated[bool, what(MINIMAL, "--minimal")] = False,
    family: Annotated[bool, what(FAMILY, "--family")] = False,
    with_: Annotated[Names, what(WITH, "--with", metavar="EXTRAS", values=EXTRAS)] = None,
    template: Annotated[str, what("A template of your own, instead of --type.", metavar="DIR|GIT-URL")] = "",
    depends: Annotated[Names, what(DEPENDS, "--depends", "--dependencies", metavar="KEYS", values=KEYS)] = None,
    distro: Annotated[str, what("The ROS distribution.", metavar="DISTRO", default=DISTRO, values=DISTROS)] = "",
    description: Annotated[str, who("What the package does, in one sentence.")] = "",
    license: Annotated[
        str, who("The license, as an SPDX identifier.", metavar="SPDX", default="Apache-2.0", values=LICENSES)
    ] = "",
    maintainer: Annotated[str, who("Name of the maintainer.", *MAINTAINER, metavar="NAME", default="from git")] = "",
    email: Annotated[str, who("E-mail address of the maintainer.", *EMAIL, metavar="ADDRESS", default="from git")] = "",
    version: Annotated[str, who("MAJOR.MINOR.PATCH.", default="0.1.0")] = "",
    year: Annotated[int, who("Year of the copyright.", default="this year")] = 0,
    into: Annotated[Path, where("The folder to write it into.", *INTO, metavar="DIR")] = Path(),
    dry_run: Annotated[bool, where("Show the tree and every file; write nothing.", "--dry-run")] = False,
    diff: Annotated[bool, where(DIFF, "--diff")] = False,
    force: Annotated[bool, where(FORCE, "--force")] = False,
    skip: Annotated[bool, where("Write only files that are missing there.", "--skip")] = False,
    update: Annotated[Path | None, where(UPDATE, "--update", metavar="PACKAGE", default=False)] = None,
    record: Annotated[bool, where(RECORD, "--record/--no-record", default=False)] = True,
    interactive: Annotated[bool, Option("--interactive", "-i", help="Ask for everything that was not given.")] = False,
    color: Annotated[str, Option(metavar="WHEN", help="auto, always or never.")] = "auto",
) -> int:
    """Write a package that builds, runs, and passes its own tests and our linter."""
    from ...light_dataclasses import replace
    from ...scaffold.answers import Request
    from ...scaffold.extras import without_none
    from .asked import ask_all, update_at
    from .check_together import check_together
    from .place import named_place
    from .run import new as write_new

    one_of("--color", color, ("auto", "always", "never"))
    has_values, params = not (no_params or params == "none"), params.replace("none", "")
    if family and name in (".", ".."):
        raise UsageError("--family writes four packages; name the robot, and their folder with --into")
    name, into = named_place(name, into)
    type = "plugin" if plugin and type == TYPES[0] else type
    request = Request(
        name, type, split(node), split(depends), tuple(msg or ()), tuple(srv or ()), tuple(action or ()), launch,
        has_values, tests, split(with_), template, description, license, maintainer, email, version, distro, year,
        minimal, split(plugin), params,
    )  # fmt: skip
    if update is not None:
        return update_at(update, request, dry_run, diff, color, force or skip or family or interactive or not record)
    request = replace(request, extras=without_none(request.extras))
    check_together(request, diff or force or skip, force and skip, family)
    if interactive and type == "workspace":
        raise UsageError("-i asks for packages; a workspace is written without questions")
    if interactive:
        request = ask_all(request, into)
    elif not name:
        raise UsageError("a package name is required: `rospkg new my_robot_nav`; `rospkg new -i` asks for everything")
    if family:
        from .family import new_family

        return new_family(request, into, dry_run, color, interactive, record)
    existing = "force" if force else "skip" if skip else ""
    return write_new(request, into, dry_run, color, existing, diff, interactive, record)
