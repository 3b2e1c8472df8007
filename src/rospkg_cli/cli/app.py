"""The command line: the verbs, and the exit status of their errors."""

from __future__ import annotations

import sys
from typing import Annotated, Any

import typer

from .. import __version__
from .add.options import adding, removing
from .cache import options as cache
from .doctor import options as doctor
from .exit_status import CTRL_C, interrupted, status_of
from .explain import options as explain
from .format import options as format
from .graph import options as graph
from .index import options as index
from .inspect import options as inspect
from .lint import options as lint
from .new import options as new
from .rename import options as rename
from .server import options as server
from .streams import guarded, say
from .upgrade import options as upgrade


def without_verbs() -> typer.Typer:
    return typer.Typer(
        name="rospkg",
        no_args_is_help=True,
        context_settings={"help_option_names": ["-h", "--help"]},
        pretty_exceptions_enable=False,
        rich_markup_mode="rich",
        help="Write correct ROS 2 packages, and find mistakes in existing ones.",
        epilog="Examples:  rospkg new my_robot_nav  ·  rospkg lint src/  ·  rospkg explain SET101",
    )


app = without_verbs()


def verb_words(incomplete: str) -> list[str]:
    return [each for each in verbs() if each.startswith(incomplete)]


def verbs() -> list[str]:
    """Return the verbs as they are typed."""
    commands = [each.name or getattr(each.callback, "__name__", "") for each in app.registered_commands]
    return [*commands, *(each.name or "" for each in app.registered_groups)]


app.command(cls=new.NewCommand, epilog=new.EPILOG)(new.new)
app.add_typer(adding, name="add")
app.add_typer(removing, name="remove")
app.command(epilog=lint.EPILOG)(lint.lint)
app.command(epilog=format.EPILOG)(format.format)
app.command(epilog=inspect.EPILOG)(inspect.inspect)
app.command(epilog=graph.EPILOG)(graph.graph)
app.command(epilog=doctor.EPILOG)(doctor.doctor)
indexing = typer.Typer(no_args_is_help=True, help=index.HELP, epilog=index.EPILOG)
indexing.command(epilog=index.UPDATE_EPILOG)(index.update)
indexing.command(epilog=index.STATUS_EPILOG)(index.status)
app.add_typer(indexing, name="index")
caching = typer.Typer(help=cache.HELP, epilog=cache.EPILOG)
caching.callback(invoke_without_command=True)(cache.cache)
caching.command()(cache.clear)
app.add_typer(caching, name="cache")
app.command(epilog=rename.EPILOG)(rename.rename)
app.command(epilog=upgrade.EPILOG)(upgrade.upgrade)
app.command(epilog=server.EPILOG)(server.server)
app.command(epilog=explain.EXPLAIN_EPILOG)(explain.explain)
app.command(epilog=explain.RULES_EPILOG)(explain.rules)


@app.command("help", epilog="Examples:  rospkg help  ·  rospkg help lint")
def show_help(
    context: typer.Context,
    verb: Annotated[list[str] | None, typer.Argument(help="A command.", autocompletion=verb_words)] = None,
) -> int:
    """Show the help of a command, as `rospkg COMMAND --help` does."""
    sys.argv = ["rospkg", *(verb or ()), "--help"]
    return run_verb()


def show_version(wanted: bool) -> None:
    if wanted:
        typer.echo(f"rospkg {__version__}")
        raise typer.Exit


@app.callback()
def main(
    version: Annotated[
        bool, typer.Option("--version", "-V", callback=show_version, is_eager=True, help="Print the version and exit.")
    ] = False,
    traceback: Annotated[
        bool, typer.Option("--traceback", help="Show the traceback of an internal error.", show_default=False)
    ] = False,
) -> None:
    """Take the options that belong to no verb."""


def app_for(verb: str) -> typer.Typer:
    """Return the command line with one verb alone where that is typed, for typer builds every verb that it knows."""
    chosen = [each for each in app.registered_commands if (each.name or getattr(each.callback, "__name__", "")) == verb]
    if not chosen:
        return app
    alone = without_verbs()
    alone.callback()(main)
    alone.registered_commands = chosen
    return alone


def run() -> int:
    """Parse the command line and run the verb; return the exit status."""
    return guarded(status)


def status() -> int:
    """Parse the command line and run the verb; return its exit status, or that of its error. Raises OutputError."""
    return status_of(run_verb)


def run_verb() -> int:
    """Run the verb; return its exit status. Raises what the verb does."""
    try:
        left: Any = app_for("".join(sys.argv[1:2]))(prog_name="rospkg", standalone_mode=False)
    except typer.Exit as leave:
        return leave.exit_code
    except Exception as error:
        if hasattr(error, "format_message"):  # a click.ClickException
            return used_wrongly(error)
        raise
    if left == CTRL_C:  # what typer makes of a KeyboardInterrupt
        return interrupted(CTRL_C)
    return left if isinstance(left, int) else 0


def used_wrongly(error: Exception) -> int:
    """Print a sentence on wrong use; return the exit status."""
    from .wrong_use import wrong_use

    if sentence := wrong_use(error, sys.argv[1:], verbs()):
        say(sentence)
    return 2
