"""RPK004 not-evaluated."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import groupby

from ...checks.read_sentences import why_unknown
from ...checks.unevaluated_parts import UnevaluatedParts
from ...example import SETUP_PY, Example
from ...finding import Hit, Severity
from ...package.install_table import InstallKind, UnknownPart
from ...rule import Profile, rule
from ...source import Span

SOURCES = "['resource/' + package_name]"
SKIPPED: dict[tuple[bool, InstallKind], tuple[str, str]] = {
    (True, "share"): ("the files in share/", "SET201–SET209, LCH004"),
    (True, "executable"): ("the executables", "SET101–SET106, LCH002"),
    (True, "module"): ("the Python modules", "SET105, SET302"),
    (False, "share"): ("the files in share/", "CMK101, LCH004"),
    (False, "executable"): ("the executables", "CMK103, LCH002"),
    (False, "module"): ("the Python modules", "CMK109"),
}
"""What is unknown of setup.py or CMake, and the rules that are skipped for it."""


@rule(
    "RPK004",
    "not-evaluated",
    over=UnevaluatedParts,
    severity=Severity.INFO,
    profile=Profile.PEDANTIC,
    examples=(
        Example(
            bad={
                "setup.py": "import os\n\n"
                + SETUP_PY.replace(SOURCES, f"{SOURCES}),\n        ('share/' + package_name, [«os.environ['EXTRA']»]")
            },
            good={"setup.py": SETUP_PY},
        ),
    ),
)
def not_evaluated(parts: UnevaluatedParts) -> Iterator[Hit]:
    """
    ## What it does
    Reports an expression of setup.py or CMakeLists.txt that can't be evaluated without running it.
    A CMake macro of another package that is given something may install files too.
    It is not known then what is installed where; the message names the rules that are skipped for that.

    ## Why is this bad?
    It isn't. But what is not known is not checked, and an empty report should not hide that.

    ## When it is quiet
    What is unknown and would silence no rule is not reported, and neither is what a fault in setup.py explains (SET308,
    SET309, SET310).
    """
    for (path, span, why), group in groupby(sorted(parts.unexplained, key=place), key=place):
        python = not path.endswith(("CMakeLists.txt", ".cmake"))
        skipped = [SKIPPED[key] for each in group if (key := (python, each.what)) in SKIPPED]
        if skipped:
            whats, rules = (", ".join(dict.fromkeys(part)) for part in zip(*skipped, strict=True))
            yield Hit(path, span, f"{why}. Not all is known of {whats}: {rules} are skipped")


def place(unknown: UnknownPart) -> tuple[str, Span, str]:
    return unknown.path, unknown.span, why_unknown(unknown)
