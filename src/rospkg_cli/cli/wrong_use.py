"""What is said of a command line that can't be understood: one sentence, with a suggestion and where help is."""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence
from typing import Any

SYNONYMS = {
    "create": "new",
    "init": "new",
    "generate": "new",
    "check": "lint",
    "verify": "lint",
    "fix": "lint --fix",
    "repair": "lint --fix",
    "list": "rules",
    "config": "doctor",
    "info": "doctor",
}
"""What people type for a verb that other tools have, and the command that does it here."""


def wrong_use(error: Any, typed: Sequence[str], verbs: Collection[str]) -> str:
    """Return the sentence on an error of the command line, as click raises it; "" where the help was shown instead."""
    message = error.format_message()
    if not message:
        return ""
    context = getattr(error, "ctx", None)
    verb = next((word for word in typed if word in verbs), "")
    command = context.command_path if context else f"rospkg {verb}".strip()
    if message.startswith("Got unexpected extra argument") and any(word.startswith("--depend") for word in typed):
        return f"names of dependencies are joined by commas: --depends rclpy,std_msgs; `{command} --help` shows how"
    return f"{what_is_wrong(error, context, message, verbs)}; `{command} --help` shows how"


def what_is_wrong(error: Any, context: Any, message: str, verbs: Collection[str]) -> str:
    from ..suggest import did_you_mean, nearest

    if name := getattr(error, "option_name", None) if hasattr(error, "possibilities") else None:
        options = [each for parameter in context.command.params for each in parameter.opts] if context else []
        return f"there is no option `{name}`{did_you_mean(name, options)}"
    if found := re.match(r"No such command '(.*?)'\.", message, re.DOTALL):
        meant = SYNONYMS.get(found[1]) or nearest(found[1], verbs)
        return f"there is no command `{found[1]}`" + (f" (did you mean `rospkg {meant}`?)" if meant else "")
    return message[:1].lower() + message[1:].rstrip(".")
