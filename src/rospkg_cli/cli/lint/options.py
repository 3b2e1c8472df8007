"""The options of `rospkg lint`."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from typer import Argument, Option

from ..complete import choices, distro_names, format_names, listed, rule_codes
from .typed_options import lint_as_typed

EPILOG = "Examples:  rospkg lint  ·  rospkg lint src/ --fix  ·  rospkg lint . --select SET --format json"
CHOICE, SUPPRESSION, FIXES, OUTPUT = "Which rules", "Suppression and baseline", "Fixes", "Output"
CONFIG = "Configuration"
FORMAT_HELP = "text, concise, json, sarif, github, gitlab, junit, rdjson, markdown or html."

CODES, DISTROS, FORMATS = listed(rule_codes), listed(distro_names), listed(format_names)
LEVELS, SHOWN = choices("error", "warning", "info"), listed(lambda: ("info", "all"))
WHEN = choices("auto", "always", "never")

Names = list[str] | None


def lint(
    paths: Annotated[list[Path] | None, Argument(help="Packages, folders of packages, or files in them.")] = None,
    select: Annotated[
        Names, Option(metavar="CODES", autocompletion=CODES, help="Run only these rules.", rich_help_panel=CHOICE)
    ] = None,
    ignore: Annotated[
        Names, Option(metavar="CODES", autocompletion=CODES, help="Do not run these rules.", rich_help_panel=CHOICE)
    ] = None,
    extend_select: Annotated[
        Names, Option(metavar="CODES", autocompletion=CODES, help="Run these rules too.", rich_help_panel=CHOICE)
    ] = None,
    pedantic: Annotated[
        bool, Option("--pedantic", help="Also run rules on matters of taste.", rich_help_panel=CHOICE)
    ] = False,
    release: Annotated[
        bool, Option("--release", help="Also run rules for packages that will be released.", rich_help_panel=CHOICE)
    ] = False,
    preview: Annotated[
        bool, Option("--preview", help="Also run rules that are new in this release.", rich_help_panel=CHOICE)
    ] = False,
    target: Annotated[
        Names,
        Option(
            metavar="DISTROS",
            autocompletion=DISTROS,
            help="humble,jazzy,…",
            show_default="$ROS_DISTRO",
            rich_help_panel=CHOICE,
        ),
    ] = None,
    fix: Annotated[bool, Option("--fix", help="Fix what can be fixed safely.", rich_help_panel=FIXES)] = False,
    fix_level: Annotated[
        str | None,
        Option(
            metavar="LEVEL",
            autocompletion=LEVELS,
            help="Fix findings of this level or above: error, warning or info.",
            show_default="warning",
            rich_help_panel=FIXES,
        ),
    ] = None,
    unsafe_fixes: Annotated[
        bool,
        Option(
            "--unsafe-fixes", help="With --fix or --diff: also fixes that may change behaviour.", rich_help_panel=FIXES
        ),
    ] = False,
    diff: Annotated[
        bool, Option("--diff", help="Show what --fix would change; change nothing.", rich_help_panel=FIXES)
    ] = False,
    fix_only: Annotated[
        bool, Option("--fix-only", help="Fix, and do not report what is left.", rich_help_panel=FIXES)
    ] = False,
    show_fixes: Annotated[
        bool, Option("--show-fixes", help="List every fix, not only the first.", rich_help_panel=FIXES)
    ] = False,
    exit_non_zero_on_fix: Annotated[
        bool,
        Option("--exit-non-zero-on-fix", help="Exit with status 1 when files were changed.", rich_help_panel=FIXES),
    ] = False,
    add_ignores: Annotated[
        str | None,
        Option(metavar="REASON", help="Write an ignore comment at each finding.", rich_help_panel=SUPPRESSION),
    ] = None,
    baseline: Annotated[
        Path | None,
        Option(metavar="FILE", help="Report only findings that are not in this baseline.", rich_help_panel=SUPPRESSION),
    ] = None,
    write_baseline: Annotated[
        Path | None,
        Option(metavar="FILE", help="Write the present findings to a baseline.", rich_help_panel=SUPPRESSION),
    ] = None,
    format: Annotated[
        str, Option("--format", metavar="FORMAT", autocompletion=FORMATS, help=FORMAT_HELP, rich_help_panel=OUTPUT)
    ] = "text",
    output: Annotated[
        Names, Option(metavar="FORMAT:FILE", help="Also write a report to a file.", rich_help_panel=OUTPUT)
    ] = None,
    statistics: Annotated[bool, Option("--statistics", help="Count findings by rule.", rich_help_panel=OUTPUT)] = False,
    fail_on: Annotated[
        str | None,
        Option(
            metavar="LEVEL",
            autocompletion=LEVELS,
            help="error, warning or info.",
            show_default="warning",
            rich_help_panel=OUTPUT,
        ),
    ] = None,
    exit_zero: Annotated[
        bool, Option("--exit-zero", help="Exit with status 0 whatever is found.", rich_help_panel=OUTPUT)
    ] = False,
    color: Annotated[
        str, Option(metavar="WHEN", autocompletion=WHEN, help="auto, always or never.", rich_help_panel=OUTPUT)
    ] = "auto",
    quiet: Annotated[
        bool, Option("--quiet", "-q", help="Print nothing when there are no problems.", rich_help_panel=OUTPUT)
    ] = False,
    show: Annotated[
        Names,
        Option(
            metavar="WHAT",
            autocompletion=SHOWN,
            help="In text: info (infos too), all (each finding in full).",
            rich_help_panel=OUTPUT,
        ),
    ] = None,
    traceback: Annotated[
        bool, Option("--traceback", help="Show the traceback of an internal error.", rich_help_panel=OUTPUT)
    ] = False,
    config: Annotated[
        Path | None, Option(metavar="FILE", help="Use this config, and no other.", rich_help_panel=CONFIG)
    ] = None,
    isolated: Annotated[bool, Option("--isolated", help="Use no config at all.", rich_help_panel=CONFIG)] = False,
    show_settings: Annotated[
        bool, Option("--show-settings", help="Show which config holds for which packages.", rich_help_panel=CONFIG)
    ] = False,
    workspace: Annotated[Path | None, Option(metavar="DIR", help="Use the packages below for lookups only.")] = None,
    changed: Annotated[bool, Option("--changed", help="Only packages with changes that are not committed.")] = False,
    since: Annotated[
        str | None, Option(metavar="REF", help="Only packages that have changed since a branch, tag or commit.")
    ] = None,
    stdin_filename: Annotated[
        Path | None, Option(metavar="FILE", help="With `-` for PATHS: the file that standard input stands for.")
    ] = None,
    jobs: Annotated[str, Option("--jobs", "-j", metavar="N|auto", help="Number of processes.")] = "auto",
    allow_empty: Annotated[bool, Option("--allow-empty", help="Succeed when no package is found.")] = False,
    watch: Annotated[bool, Option("--watch", help="Lint again whenever a file changes, until Ctrl-C.")] = False,
    no_cache: Annotated[bool, Option("--no-cache", help="Use nothing of earlier runs, and keep nothing.")] = False,
) -> int:
    """Find mistakes in packages; --fix corrects them."""
    return lint_as_typed(dict(locals()))
