"""What is added to a message where a fault stops other packages, and none of these is known."""

from __future__ import annotations

UNMET = " (no package here is known to meet it)"


def by_whom(message: str, is_met: bool) -> str:
    """Return a message, with the reason why its finding is an info where no package here meets the fault."""
    return message if is_met else message + UNMET
