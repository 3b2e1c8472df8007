"""The options of `rospkg lint`."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

from typer import Argument, Option

from .. import UsageError
from ..arguments import one_of, split

EPILOG = "Examples:  rospkg lint  ·  rospkg lint src/ --fix  ·  rospkg lint . --select SET --format json"
CHOICE, SILENCE, REPAIR, OUTPUT = "Which rules", "Silence and adoption", "Repair", "Output"
FORMAT_HELP = "text, concise, json, sarif, github, gitlab, junit, rdjson or markdown."

Names = list[str] | None


def lint(
    paths: Annotated[list[Path] | None, Argument(help="Packages, folders of packages, or files in them.")] = None,
    select: Annotated[Names, Option(metavar="CODES", help="Run only these.", rich_help_panel=CHOICE)] = None,
    ignore: Annotated[Names, Option(metavar="CODES", help="Leave these out.", rich_help_panel=CHOICE)] = None,
    extend_select: Annotated[Names, Option(metavar="CODES", help="Run these too.", rich_help_panel=CHOICE)] = None,
    pedantic: Annotated[bool, Option("--pedantic", help="Also matters of taste.", rich_help_panel=CHOICE)] = False,
    release: Annotated[
        bool, Option("--release", help="Also what a release into a distribution wants.", rich_help_panel=CHOICE)
    ] = False,
    preview: Annotated[
        bool, Option("--preview", help="Also rules that are new in this release.", rich_help_panel=CHOICE)
    ] = False,
    target: Annotated[
        Names,
        Option(metavar="DISTROS", help="humble,jazzy,… (else $ROS_DISTRO, else unknown).", rich_help_panel=CHOICE),
    ] = None,
    fix: Annotated[bool, Option("--fix", help="Repair what can be repaired safely.", rich_help_panel=REPAIR)] = False,
    unsafe_fixes: Annotated[
        bool, Option("--unsafe-fixes", help="With --fix: also what changes a meaning.", rich_help_panel=REPAIR)
    ] = False,
    diff: Annotated[
        bool, Option("--diff", help="Show what --fix would change; change nothing.", rich_help_panel=REPAIR)
    ] = False,
    exit_non_zero_on_fix: Annotated[
        bool, Option("--exit-non-zero-on-fix", help="Leave with 1 when files were changed.", rich_help_panel=REPAIR)
    ] = False,
    add_ignores: Annotated[
        str | None,
        Option(metavar="REASON", help="Write an ignore comment at each finding.", rich_help_panel=SILENCE),
    ] = None,
    baseline: Annotated[
        Path | None, Option(metavar="FILE", help="Report only what is not in it.", rich_help_panel=SILENCE)
    ] = None,
    write_baseline: Annotated[
        Path | None, Option(metavar="FILE", help="Write what is found now to a file.", rich_help_panel=SILENCE)
    ] = None,
    format: Annotated[str, Option("--format", metavar="FORMAT", help=FORMAT_HELP, rich_help_panel=OUTPUT)] = "text",
    output: Annotated[
        Names, Option(metavar="FORMAT:FILE", help="Write a report to a file, too.", rich_help_panel=OUTPUT)
    ] = None,
    statistics: Annotated[bool, Option("--statistics", help="Count findings by rule.", rich_help_panel=OUTPUT)] = False,
    fail_on: Annotated[
        str | None,
        Option(metavar="LEVEL", help="error, warning or info (else warning).", rich_help_panel=OUTPUT),
    ] = None,
    color: Annotated[str, Option(metavar="WHEN", help="auto, always or never.", rich_help_panel=OUTPUT)] = "auto",
    quiet: Annotated[
        bool, Option("--quiet", "-q", help="Say nothing where nothing is wrong.", rich_help_panel=OUTPUT)
    ] = False,
    verbose: Annotated[
        bool, Option("--verbose", "-v", help="Show the traceback of a fault of ours.", rich_help_panel=OUTPUT)
    ] = False,
    workspace: Annotated[
        Path | None, Option(metavar="DIR", help="Its packages are known, but not reported on.")
    ] = None,
    jobs: Annotated[str, Option("--jobs", "-j", metavar="N|auto", help="How many processes.")] = "auto",
    allow_empty: Annotated[bool, Option("--allow-empty", help="No package found is no error.")] = False,
) -> int:
    """Check packages; --fix repairs."""
    typed: dict[str, Any] = dict(locals())
    from ...report import FORMATS
    from .lint_options import LintOptions
    from .run import lint as run_lint

    one_of("--format", format, FORMATS)
    one_of("--color", color, ("auto", "always", "never"))
    if fail_on is not None:
        one_of("--fail-on", fail_on, ("error", "warning", "info"))
    if workspace is not None and not workspace.is_dir():
        raise UsageError(f"--workspace: `{workspace}` is not a folder")
    typed |= {name: split(typed[name]) for name in ("select", "ignore", "extend_select", "target")}
    typed |= {name: tuple(typed[name] or ()) for name in ("paths", "output")}
    return run_lint(LintOptions.of(typed))
