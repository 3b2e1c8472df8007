"""Faults that a course put into its packages on purpose, as its pages say: to find them is the exercise."""

from __future__ import annotations

import re

from ...files import PackageFiles
from ...finding import Finding
from ...lazy_regex import regex
from ...package.workspace import Workspace
from .milder import RuleResults, as_infos

PAGES = (".md", ".rst", ".txt")
TOLD_ABOVE = tuple(f"{name}{end}" for name in ("README", "Readme", "readme") for end in PAGES)
ON_PURPOSE = r"(?:on purpose|intentionally|deliberately|purposely|purposefully|knowingly)"
MEANT = r"(?:intentional|deliberate|planted|purposeful)"
SURE = r"(?:bugs?|defects?|mistakes?)"
PLANTED = regex(
    rf"(?i)\b{MEANT}(?:\s+[\w-]+){{0,2}}\s+{SURE}\b|\b{SURE}\b[^.;:\n]{{0,60}}\b{ON_PURPOSE}\b"
    rf"|\b{ON_PURPOSE}\b[^.;:\n]{{0,30}}\b(?:{SURE}|broken|buggy|flawed|faulty)(?![\w-])"
    rf"|\b(?:broken|buggy|flawed|faulty)\b[^.;:\n]{{0,30}}\b{ON_PURPOSE}\b"
)
"""How a page says that something is wrong on purpose."""
OF_CODE = regex(
    r"(?i)\b(?:code|sources?|files?|packages?|nodes?|launch|workspace|repo(?:sitory)?|projects?|exercises?|tasks?"
    r"|participants?|students?|debug\w*)\b|\w\.(?:py|cpp|hpp|xml|ya?ml|urdf|xacro)\b"
)
"""Words for code with such faults, or for those who look for them, as opposed to faults that a robot simulates."""
INJECTS = regex(
    r"(?i)\binject\w*|\bsimulat\w*|\b(?:fix(?:ed|es)|removed?|no)\b[^.\n]{0,40}\b(?:intentional|deliberate)"
)
WHOLE = regex(
    r"\b[Tt]h(?:is|e) (?:\w+ )?(?:repo(?:sitory)?|workspace|project)\b|\b(?:[Aa]ll|[Ee]ach|[Tt]hese) packages?\b"
)
"""How a page above means all packages of a repository."""
BETWEEN_TWO = ("IDL01", "LCH", "PLG", "PRM")
"""Rules about what one package asks of another one: the fault may lie in either."""
NAMED = regex("`([^`]+)`")
WHY = "; a page says that faults are planted here on purpose"


def with_planted_faults(results: RuleResults, files: PackageFiles, folder: str, workspace: Workspace) -> RuleResults:
    """Return the results of a package with an info for each finding where a page says that faults are on purpose."""
    codes = frozenset(each.code for each in results if isinstance(each, Finding) and each.is_loud)
    if codes and is_planted(files, folder):
        return as_infos(results, codes, lambda _: WHY)
    between = frozenset(code for code in codes if code.startswith(BETWEEN_TWO))
    return as_infos(results, between, lambda found: why_in_another(found, files, folder, workspace))


def why_in_another(found: Finding, files: PackageFiles, folder: str, workspace: Workspace) -> str:
    """Return the end of a message on a finding that names a package with planted faults; "" for others."""
    for name in NAMED.findall(found.message):
        other = workspace.named(name)
        if other is not None and other.folder != folder and is_planted(files, other.folder):
            return WHY.replace("here", f"in `{name}`")
    return ""


def is_planted(files: PackageFiles, folder: str) -> bool:
    """Return whether a page in the folder of a package says so, or one above it, of all packages or of this one."""
    if files.whole is None:
        return any(planting(files, path) for path in files.paths if path.endswith(PAGES))
    own, whole = PackageFiles(files.whole.sub(folder), folder, files.whole), PackageFiles(files.whole)
    if any(planting(own, path) for path in own.paths if path.endswith(PAGES)):
        return True
    parts = folder.split("/")
    named = re.compile(rf"(?<![\w-]){re.escape(parts[-1])}(?![\w-])|{WHOLE.pattern}")
    tree, depths = files.whole.files(), range(len(parts)) if folder else ()
    above = ("/".join((*parts[:depth], name)) for depth in depths for name in TOLD_ABOVE)
    return any(named.search(line) for path in above if path in tree for line in planting(whole, path))


def planting(files: PackageFiles, path: str) -> list[str]:
    """Return the lines of a page that say that something in code is wrong on purpose."""
    lines = files.page_text(path).split("\n")
    return [each for each in lines if PLANTED.search(each) and OF_CODE.search(each) and not INJECTS.search(each)]
