"""What a reader knows of the surroundings: distributions that pages name, platforms, and nodes made elsewhere."""

from __future__ import annotations

from dataclasses import replace

from rospkg_cli.example import Example

from .shown_fields import code

PAGES = ("For Humble.\n", "For Humble and Jazzy.\n", "For Jazzy.\n", "For Foxy.\n")
MADE = "\nprint(Status(batery=1))\n"


def below(page: str, text: str) -> Example:
    """A repository with a page beside its packages."""
    given = code(text)
    return replace(given, bad={**given.bad, "README.md": page})


CASES = {
    "IDL010": (
        *(below(page, MADE) for page in PAGES),
        below("For Jazzy.\n", f"{MADE}msg = Status()\nmsg.batery = 1\n"),
    ),
}
