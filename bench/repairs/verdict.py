"""Whether the rules that fit name a fault on the tree before its repair, and none of them on the tree after it."""

from __future__ import annotations

import io
import json
import re
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from bench.repairs.checkout import checkout
from bench.repairs.fitting import DEPENDENCY, FITTING, NAMELESS
from rospkg_cli.cli.lint.lint_options import LintOptions, ReportOptions, RuleOptions
from rospkg_cli.cli.lint.run import lint_to

Repair = dict[str, str]
BRINGER = re.compile(r"\bcomes? with [^;:]*")
"""Names a package that serves today in place of the one that lacks: it is not at fault."""
KEY, DEV = r"(?:python3-|lib)?", r"(?:-dev)?"
"""How the key of rosdep for a module or library begins and ends: `libceres-dev` names `ceres`."""


def verdict(mirror: Path, repair: Repair) -> str:
    """Return `solved`, `not found`, or `still told`; raises CalledProcessError where the repository lacks a commit."""
    git_dir = mirror / repair["repo"].replace("/", "+") / "repo"
    with tempfile.TemporaryDirectory(prefix="repair-") as scratch:
        before, after = Path(scratch, "before"), Path(scratch, "after")
        checkout(git_dir, repair["before"], before)
        checkout(git_dir, repair["after"], after)
        spoke = naming(repair, findings(before, repair["package"]))
        still = [code for code in naming(repair, findings(after, repair["package"])) if code in spoke]
    if not spoke:
        return "not found"
    is_gone = len(still) < len(spoke) if repair["class"] in NAMELESS else not still
    return "solved" if is_gone else "still told"


def findings(tree: Path, package: str) -> list[dict[str, Any]]:
    if not (tree / package).is_dir():
        return []
    stream = io.StringIO()
    options = LintOptions(
        paths=(tree / package,),
        workspace=tree,
        jobs="1",
        no_cache=True,
        rules=RuleOptions(pedantic=True, release=True),
        report=ReportOptions(format="json", quiet=True),
    )
    lint_to(options, stream)
    found: list[dict[str, Any]] = json.loads(stream.getvalue())["findings"]
    return found


def naming(repair: Repair, found: Sequence[dict[str, Any]]) -> list[str]:
    """Return the codes of the fitting findings that name the fault: its token as a word, a file also by its path."""
    token = repair["token"].lower()
    key, dev = (KEY, DEV) if FITTING[repair["class"]] is DEPENDENCY else ("", "")
    word = re.compile(rf"(?<![\w-]){key}{re.escape(token)}{dev}(?![\w-])")
    codes = []
    for finding in found:
        text = BRINGER.sub("", finding["message"].lower()) + (f" {finding['path'].lower()}" if "." in token else "")
        is_named = repair["class"] in NAMELESS or word.search(text)
        if is_named and finding["code"].startswith(FITTING[repair["class"]]):
            codes.append(finding["code"])
    return codes
