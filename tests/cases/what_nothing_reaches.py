"""What nothing leads to: modules, methods and branches that are told of in a milder way."""

from __future__ import annotations

from .undefined_names import talker

BROKEN = "def draw():\n    print(modes)\n"

CASES = {
    "DEP117": (
        talker(
            "from my_pkg.dot_qt import GREETING\n\n\ndef main(): ...\n",
            my_pkg__dot=BROKEN,
            my_pkg__dot_qt="GREETING = 1\n",
        ),
    ),
}
