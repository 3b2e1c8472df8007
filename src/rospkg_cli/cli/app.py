"""The verbs and their options. Bodies import what they call, so that a start stays short."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated, Any

import typer

from .. import __version__
from . import UsageError

HELP = {"help_option_names": ["-h", "--help"]}
app = typer.Typer(
    name="rospkg",
    no_args_is_help=True,
    context_settings=HELP,
    pretty_exceptions_enable=False,
    rich_markup_mode="rich",
    help="Write ROS 2 packages that are right, and find what is wrong in those that exist.",
    epilog="Examples:  rospkg new my_robot_nav  ·  rospkg lint src/  ·  rospkg explain SET101",
)

Names = Annotated[list[str] | None, typer.Option(metavar="CODES", help="Comma-separated codes, names or prefixes.")]


def show_version(wanted: bool) -> None:
    if wanted:
        typer.echo(f"rospkg {__version__}")
        raise typer.Exit


@app.callback()
def main(
    version: Annotated[
        bool, typer.Option("--version", "-V", callback=show_version, is_eager=True, help="Print the version and leave.")
    ] = False,
) -> None:
    """Take the options that belong to no verb."""


def split(values: list[str] | None) -> tuple[str, ...]:
    """Return the names of a repeatable, comma-separated option."""
    return tuple(name.strip() for value in values or () for name in value.split(",") if name.strip())


LINT_EPILOG = "Examples:  rospkg lint  ·  rospkg lint src/ --fix  ·  rospkg lint . --select SET --format json"


@app.command(epilog=LINT_EPILOG)
def lint(
    paths: Annotated[list[Path] | None, typer.Argument(help="Packages, folders of packages, or files in them.")] = None,
    select: Annotated[list[str] | None, typer.Option(metavar="CODES", help="Run only these rules.")] = None,
    ignore: Annotated[list[str] | None, typer.Option(metavar="CODES", help="Leave these rules out.")] = None,
    extend_select: Annotated[list[str] | None, typer.Option(metavar="CODES", help="Run these rules too.")] = None,
    pedantic: Annotated[bool, typer.Option("--pedantic", help="Also what is a matter of taste.")] = False,
    release: Annotated[bool, typer.Option("--release", help="Also what a release into a distribution wants.")] = False,
    target: Annotated[
        list[str] | None, typer.Option(metavar="DISTROS", help="humble, jazzy, … [default: $ROS_DISTRO, else unknown]")
    ] = None,
    fail_on: Annotated[
        str | None, typer.Option(metavar="LEVEL", help="error, warning or info. [default: warning]")
    ] = None,
    fix: Annotated[bool, typer.Option("--fix", help="Repair what can be repaired safely.")] = False,
    unsafe_fixes: Annotated[
        bool, typer.Option("--unsafe-fixes", help="With --fix: also what changes a meaning.")
    ] = False,
    diff: Annotated[bool, typer.Option("--diff", help="Show what --fix would change; change nothing.")] = False,
    exit_non_zero_on_fix: Annotated[
        bool, typer.Option("--exit-non-zero-on-fix", help="Leave with 1 when files were changed.")
    ] = False,
    format: Annotated[str, typer.Option("--format", metavar="FORMAT", help="text, concise, json or github.")] = "text",
    output: Annotated[
        list[str] | None, typer.Option(metavar="FORMAT:FILE", help="Write a report to a file too.")
    ] = None,
    workspace: Annotated[
        Path | None, typer.Option(metavar="DIR", help="Its packages are known, but not reported on.")
    ] = None,
    jobs: Annotated[str, typer.Option("--jobs", "-j", metavar="N|auto", help="How many processes.")] = "auto",
    allow_empty: Annotated[bool, typer.Option("--allow-empty", help="No package found is no error.")] = False,
    color: Annotated[str, typer.Option(metavar="WHEN", help="auto, always or never.")] = "auto",
    quiet: Annotated[bool, typer.Option("--quiet", "-q", help="Say nothing when there is nothing to say.")] = False,
    verbose: Annotated[bool, typer.Option("--verbose", "-v", help="Show the traceback of a fault of ours.")] = False,
) -> int:
    """Check packages; --fix repairs."""
    from ..report import FORMATS
    from .lint import LintOptions
    from .lint import lint as run_lint

    one_of("--format", format, FORMATS)
    one_of("--color", color, ("auto", "always", "never"))
    if fail_on is not None:
        one_of("--fail-on", fail_on, ("error", "warning", "info"))
    if workspace is not None and not workspace.is_dir():
        raise UsageError(f"--workspace: `{workspace}` is not a folder")
    return run_lint(
        LintOptions(
            paths=tuple(paths or ()),
            select=split(select),
            ignore=split(ignore),
            extend_select=split(extend_select),
            pedantic=pedantic,
            release=release,
            target=split(target),
            fail_on=fail_on,
            fix=fix,
            unsafe_fixes=unsafe_fixes,
            diff=diff,
            exit_non_zero_on_fix=exit_non_zero_on_fix,
            format=format,
            output=tuple(output or ()),
            workspace=workspace,
            jobs=jobs,
            allow_empty=allow_empty,
            color=color,
            verbose=verbose,
            quiet=quiet,
        )
    )


def one_of(option: str, value: str, allowed: tuple[str, ...]) -> None:
    from ..suggest import did_you_mean

    if value not in allowed:
        raise UsageError(f"{option} wants one of {', '.join(allowed)}; not `{value}`{did_you_mean(value, allowed)}")


@app.command(epilog="Examples:  rospkg explain SET101  ·  rospkg explain empty-glob")
def explain(rule: Annotated[str, typer.Argument(help="A code or a name.")]) -> None:
    """What a rule finds, why, a bad and a good example, and its fix."""
    from .explain import explain as text

    if sys.stdout.isatty():
        from rich.console import Console
        from rich.markdown import Markdown

        Console().print(Markdown(text(rule)))
    else:
        typer.echo(text(rule), nl=False)


@app.command(epilog="Example:  rospkg rules --format json")
def rules(format: Annotated[str, typer.Option("--format", metavar="FORMAT", help="text or json.")] = "text") -> None:
    """List all rules."""
    from .explain import rules_json, rules_text

    one_of("--format", format, ("text", "json"))
    typer.echo(rules_json() if format == "json" else rules_text(), nl=False)


def run() -> int:
    """Parse the command line and run the verb; return the exit status."""
    from ..configkeys import ConfigError
    from ..engine.locate import LocateError
    from ..engine.write import WriteError

    try:
        status: Any = app(prog_name="rospkg", standalone_mode=False)
        return status if isinstance(status, int) else 0
    except typer.Exit as leave:
        return leave.exit_code
    except (UsageError, ConfigError, LocateError, WriteError) as error:
        print(f"rospkg: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("rospkg: interrupted; nothing was written half", file=sys.stderr)
        return 130
    except Exception as error:
        return failed(error)


def failed(error: Exception) -> int:
    """Say what click or we ourselves could not do; return the exit status."""
    shown = getattr(error, "format_message", None)
    if shown is not None:  # a click.ClickException: wrong use
        context = getattr(error, "ctx", None)
        print(f"rospkg: {shown()} `{context.command_path if context else 'rospkg'} --help` shows how.", file=sys.stderr)
        return 2
    if "-v" in sys.argv or "--verbose" in sys.argv:
        raise error
    what = f"{type(error).__name__}: {error}"
    print(f"rospkg: a fault of ours: {what}; please report it with the output of -v", file=sys.stderr)
    return 3
