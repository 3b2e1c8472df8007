"""A few colours, and none where they are not wanted."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import IO

from ..finding import Severity

CODES: Mapping[str, str] = {
    "bold": "1",
    "dim": "2",
    "red": "1;31",
    "yellow": "1;33",
    "blue": "1;34",
    "green": "32",
    "cyan": "36",
}
SEVERITY_COLORS = {Severity.ERROR: "red", Severity.WARNING: "yellow", Severity.INFO: "blue"}


def paint(text: str, name: str, color: bool) -> str:
    """Return a text in a color of CODES, or as a link that terminals open (OSC 8) where an address is named."""
    if not color or not text:
        return text
    if name.startswith("https://"):
        return f"\x1b]8;;{name}\x1b\\{text}\x1b]8;;\x1b\\"
    return f"\x1b[{CODES[name]}m{text}\x1b[0m"


def wants_color(choice: str, stream: IO[str], environment: Mapping[str, str] = os.environ) -> bool:
    """Return whether to colour: `--color`, then NO_COLOR and FORCE_COLOR, then whether it is a terminal."""
    if choice != "auto":
        return choice == "always"
    if environment.get("NO_COLOR"):
        return False
    if environment.get("FORCE_COLOR"):
        return True
    return stream.isatty() and environment.get("TERM") != "dumb"
