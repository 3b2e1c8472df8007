"""The options of `rospkg add` and `rospkg remove`."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

from typer import Argument, Option, Typer

if TYPE_CHECKING:
    from ..change.finish import ChangeOptions

ADD_HELP = "Add to a package that exists; nothing that stands there changes."
ADD_EPILOG = "Examples:  rospkg add node talker:publisher  ·  rospkg add launch up  ·  rospkg add msg Status"
REMOVE_HELP = "Take away what `rospkg add` put into a package."
REMOVE_EPILOG = "Examples:  rospkg remove node talker  ·  rospkg remove dependency std_msgs"

PACKAGE = "The package: its folder, a path in it, or its name below the current folder."
NODE = "NAME, NAME:KIND or NAME:KIND:LANGUAGE, as for `rospkg new --node`."
PLUGIN = "KIND or NAME:KIND, as for `rospkg new --plugin`, for $ROS_DISTRO or the newest LTS."
LAUNCH = "NAME or NAME:FORMAT; py, xml or yaml."
FIELDS = "NAME or NAME:FIELDS, as for `rospkg new`: Status:'float32 battery, string task'."
TEST = "NAME or NAME:LANGUAGE; python or cpp."
STARTS = "What it starts: an executable of the package, or PACKAGE/EXECUTABLE; repeatable."
HERE = "Generate interfaces in a package that generates none yet."
TAG = "The tag in package.xml."
DIFF = "Show what would change; exit with status 1 if anything would."
FORCE = "Remove what was edited since, or is still named."
DIRTY = "Go ahead where git could not bring the old files back."

Names = Annotated[list[str], Argument(show_default=False)]
Package = Annotated[Path, Option("--package", "-p", metavar="PATH", help=PACKAGE)]
DryRun = Annotated[bool, Option("--dry-run", help="Show which files would change; write nothing.")]
Diff = Annotated[bool, Option("--diff", help=DIFF)]
Force = Annotated[bool, Option("--force", help=FORCE)]
Dirty = Annotated[bool, Option("--allow-dirty", help=DIRTY)]


def names(metavar: str, help: str) -> Any:
    return Argument(metavar=metavar, help=help, show_default=False)


adding = Typer(no_args_is_help=True, help=ADD_HELP, epilog=ADD_EPILOG)
removing = Typer(no_args_is_help=True, help=REMOVE_HELP, epilog=REMOVE_EPILOG)


def add(what: str, typed: list[str], package: Path, options: ChangeOptions, **more: Any) -> int:
    from ...addition.wanted import Wanted
    from .run import add as run

    return run(Wanted(what, tuple(typed), **more), package, options)


def shown(dry_run: bool, diff: bool) -> ChangeOptions:
    from ..change.finish import ChangeOptions

    return ChangeOptions(dry_run, diff)


@adding.command("node")
def add_node(
    node: Annotated[list[str], names("NAME[:KIND[:LANGUAGE]]...", NODE)],
    package: Package = Path(),
    dry_run: DryRun = False,
    diff: Diff = False,
) -> int:
    """Write a node, with its executable and its dependencies."""
    return add("node", node, package, shown(dry_run, diff))


@adding.command("plugin")
def add_plugin(
    plugin: Annotated[list[str], names("[NAME:]KIND...", PLUGIN)],
    package: Package = Path(),
    dry_run: DryRun = False,
    diff: Diff = False,
) -> int:
    """Write a plugin, with its description, its library and its dependencies."""
    return add("plugin", plugin, package, shown(dry_run, diff))


@adding.command("launch")
def add_launch(
    name: Annotated[list[str], names("NAME[:FORMAT]...", LAUNCH)],
    node: Annotated[list[str] | None, Option(metavar="[PACKAGE/]EXECUTABLE", help=STARTS)] = None,
    package: Package = Path(),
    dry_run: DryRun = False,
    diff: Diff = False,
) -> int:
    """Write a launch file, install it, and declare what it needs."""
    return add("launch", name, package, shown(dry_run, diff), nodes=tuple(node or ()))


@adding.command("params")
def add_params(
    name: Annotated[list[str], names("NAME...", "The name of the file, without .yaml.")],
    package: Package = Path(),
    dry_run: DryRun = False,
    diff: Diff = False,
) -> int:
    """Write a file of parameters, and install it."""
    return add("params", name, package, shown(dry_run, diff))


def interface_command(form: str, noun: str) -> None:
    """Define `add msg`, `add srv` or `add action`."""

    @adding.command(form, help=f"Write {noun}, generate it, and declare what its types need.")
    def add_interface(
        name: Annotated[list[str], names("NAME[:FIELDS]...", FIELDS)],
        here: Annotated[bool, Option("--here", help=HERE)] = False,
        package: Package = Path(),
        dry_run: DryRun = False,
        diff: Diff = False,
    ) -> int:
        return add(form, name, package, shown(dry_run, diff), here=here)


interface_command("msg", "a message")
interface_command("srv", "a service")
interface_command("action", "an action")


@adding.command("test")
def add_test(
    name: Annotated[list[str], names("NAME[:LANGUAGE]...", TEST)],
    package: Package = Path(),
    dry_run: DryRun = False,
    diff: Diff = False,
) -> int:
    """Write a test, for pytest or GoogleTest, and have the build run it."""
    return add("test", name, package, shown(dry_run, diff))


@adding.command("dependency")
def add_dependency(
    key: Annotated[list[str], names("KEY...", "Names of ROS packages, and rosdep keys.")],
    tag: Annotated[str, Option(metavar="TAG", help=TAG, show_default="as it is used")] = "",
    package: Package = Path(),
    dry_run: DryRun = False,
    diff: Diff = False,
) -> int:
    """Declare a dependency under the right tag, in CMake too where C++ uses it."""
    return add("dependency", key, package, shown(dry_run, diff), tag=tag)


def remove_command(what: str, help: str) -> None:
    """Define one of the commands of `remove`."""

    @removing.command(what, help=help)
    def remove_one(
        name: Names,
        package: Package = Path(),
        dry_run: DryRun = False,
        diff: Diff = False,
        force: Force = False,
        allow_dirty: Dirty = False,
    ) -> int:
        from ...addition.wanted import Wanted
        from .run import remove

        return remove(Wanted(what, tuple(name), force=force), package, shown(dry_run, diff), allow_dirty)


remove_command("node", "Remove a node, its executable, and dependencies that nothing else needs.")
remove_command("plugin", "Remove a plugin, its library, and dependencies that nothing else needs.")
remove_command("launch", "Remove a launch file, and what installs it alone.")
remove_command("params", "Remove a file of parameters, and what installs it alone.")
remove_command("msg", "Remove a message.")
remove_command("srv", "Remove a service.")
remove_command("action", "Remove an action.")
remove_command("test", "Remove a test.")
remove_command("dependency", "Remove a dependency that no file names.")
