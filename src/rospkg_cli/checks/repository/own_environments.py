"""Pages that have the programs of a package run in an environment whose Python sees nothing that rosdep installs."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...files import PackageFiles
from ...lazy_regex import regex
from .pages_and_scripts import pages_and_scripts

ENTERS = regex(
    r"(?<![\w-])(?:(?:conda|mamba|micromamba)[ \t]+(?:activate|create|run|env[ \t]+create)|source[ \t]+activate"
    r"|poetry[ \t]+(?:install|run|shell)|pipenv[ \t]+(?:install|run|shell)|uv[ \t]+(?:run|sync|venv)"
    r"|(?:source|\.)[ \t]+[\w~./${}-]{0,200}\bbin/activate|python[\d.]*[ \t]+-m[ \t]+venv|virtualenv[ \t]+[\w~./-]"
    r"|isaaclab\.sh[ \t]+-p|python\.sh)(?![\w-])"
)
"""A command that makes an environment, or that runs a program in one."""
SEES_ALL = "--system-site-packages"
"""What opens an environment to the libraries of the system."""
REFUSES = regex(r"(?i)\b(?:not|never|avoid|without|instead of|no)\b|n't\b")
BUILDS = regex(r"\bcolcon[ \t]+build\b")


def environment_told(files: PackageFiles, package: str) -> str:
    """Return the command by which a page enters an environment and then builds or starts a package; "" for none."""
    starts = re.compile(rf"\bros2[ \t]+(?:run|launch)[ \t]+{re.escape(package)}(?![\w-])")
    texts = pages_and_scripts(files)
    for text in () if any(SEES_ALL in each for each in texts) else texts:
        if starts.search(text) or BUILDS.search(text):
            for command in entering(text):
                return command
    return ""


def entering(text: str) -> Iterator[str]:
    """Yield the commands that enter an environment, but for those in lines that advise against it."""
    for found in ENTERS.finditer(text):
        start = text.rfind("\n", 0, found.start()) + 1
        if REFUSES.search(text, start, found.start()) is None:
            yield " ".join(found[0].split())
