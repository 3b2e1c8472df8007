"""Which run is asked for: the command line, where it was typed, and what of the environment lint looks at."""

from __future__ import annotations

import os
import sys
from zlib import crc32

from .own_code import HERE, search_path

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import TextIO

VARIABLES = (
    *("ROS_DISTRO", "AMENT_PREFIX_PATH", "HOME", "USERPROFILE", "TMPDIR", "TEMP", "PWD"),
    *("XDG_CACHE_HOME", "XDG_CONFIG_HOME", "NO_COLOR", "FORCE_COLOR", "TERM", "COLUMNS"),
)
"""Every variable that lint asks for; `tests/test_cache_inputs.py` reads the sources for others."""

NEVER = (
    "--no-cache",
    "--fix",
    "--fix-only",
    "--diff",
    "--show-settings",
    "--add-ignores",
    "--write-baseline",
    "--watch",
    "--help",
    "-h",
)
"""Options whose runs write, or are not to be kept."""


def run_key(arguments: Sequence[str]) -> list[str] | None:
    """Return what distinguishes a run from others, as texts; None where the run must not be served from the cache."""
    if any(each.partition("=")[0] in NEVER for each in arguments) or "_ROSPKG_COMPLETE" in os.environ:
        return None
    out = sys.stdout
    if out is None:
        return None
    try:
        where = [os.getcwd(), str(is_here(os.environ.get("PWD", "")))]
    except OSError:
        return None
    shown = [str(columns(out)), str(out.encoding), str(out.errors)]
    python = [sys.version, sys.executable, HERE, str(getattr(os, "geteuid", int)()), *search_path()]
    environment = [f"{name}={value}" for name in VARIABLES if (value := os.environ.get(name)) is not None]
    parts = [list(arguments), where, shown, python, environment]
    return [text for part in parts for text in (str(len(part)), *part)]


def columns(out: TextIO) -> int | None:
    """Return the width of a terminal; None for a stream that is none."""
    if not out.isatty():
        return None
    try:
        return os.get_terminal_size(out.fileno()).columns
    except (OSError, ValueError):
        return 0


def is_here(folder: str) -> bool:
    """Return whether a folder is the current one."""
    try:
        return os.path.samefile(folder, os.curdir)
    except (OSError, ValueError):
        return False


def file_name(key: Sequence[str]) -> str:
    """Return the name of the file for a key; the key itself is in the file."""
    text = "\0".join(key).encode("utf-8", "surrogatepass")
    return f"run-{crc32(text):08x}{crc32(text[::-1]):08x}"
