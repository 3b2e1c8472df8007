"""Where the page of a rule stands: for `explain`, and for formats and editors that lead to it."""

from __future__ import annotations

from .rule import PLUGGED_IN

PAGES = "docs/rules/{code}.md"
"""Where all pages stand: below the repository, or an address that begins with https:// once the project has a site."""


def address(code: str) -> str | None:
    """Return where the page of a rule stands; None for a rule of a plugin, which has none among ours."""
    return None if code in PLUGGED_IN else PAGES.format(code=code)


def web_address(code: str) -> str | None:
    """Return the page's address where a browser can open it, as SARIF, rdjson and editors want it, or None."""
    return address(code) if PAGES.startswith("https://") else None
