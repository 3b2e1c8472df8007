"""Names of packages and executables in launch files that are empty or have a blank."""

from __future__ import annotations

from ..finding import Hit
from ..package.launch.text import LaunchText

COMMANDS = frozenset({"ros2", "run", "launch"})
"""Words of a command line, which a package may be copied from."""


def blank_name(path: str, text: LaunchText, what: str) -> Hit:
    name = (text.literal or "").strip()
    if not name:
        return Hit(path, text.span, f"the {what} of this node is empty: the launch stops; name it")
    hint = f"write `{name.split()[-1] if name.split()[0] in COMMANDS else name.replace(' ', '_')}`"
    return Hit(path, text.span, f"no package is called `{text.literal}`, with a blank: it is not found; {hint}")
