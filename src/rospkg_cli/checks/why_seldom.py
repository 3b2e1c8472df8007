"""What a message says of Python code that seldom or never runs."""

from __future__ import annotations

from typing import Literal

Met = Literal["maybe", "branch", "late", "ended", "unspun", "seldom", "unshown", "never"]
"""When code runs that does not run at every start.

- maybe: in some runs
- branch: only after another failure, with a switch, or where the file is started by its path
- late: only behind a `spin`, which Ctrl-C leaves
- ended: only after the loop in a constructor
- unspun: in a callback of a node that nothing spins
- seldom: only under several conditions at once
- unshown: no code shows how a program reaches it
- never: nothing calls it
"""

WHY: dict[Met, str] = {
    "branch": "; it runs only where its condition holds",
    "late": "; it stands behind `spin`, which Ctrl-C leaves by an exception of its own",
    "ended": "; it runs only once the loop has ended in which the program stays",
    "unspun": "; it is in a callback, and nothing spins the node",
    "seldom": "; it runs only where several conditions hold at once",
    "unshown": "; nothing here shows that a program comes to this line",
    "never": "; nothing here leads to this function",
}
"""The end of a message about code that seldom or never runs."""
MILDER: tuple[Met, ...] = ("branch", "seldom", "late", "ended", "unspun", "unshown", "never")
"""From what runs most often to what never runs."""

UNWANTED = "; nothing here leads to what imports this module"
IN_TEST = "; only a test runs it"
AT_TIMES = "; a condition stands on the way to it"
UNIMPORTED = "; nothing here imports this module"
