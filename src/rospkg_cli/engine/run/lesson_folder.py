"""Folders of a course with a few files of a package, which readers copy into one that `ros2 pkg create` makes.

The sources are next to the build file, not where that looks for them: such a folder is never built as it is.
"""

from __future__ import annotations

import re

from ...files import PackageFiles
from ...finding import Finding
from ...lazy_regex import regex
from .milder import RuleResults, as_infos

OF_MISSING = frozenset(
    "CMK101 CMK102 CMK109 CMK124 IDL006 SET101 SET201 SET202 SET203 SET205 SET301 SET302 XML304".split()
)
"""Rules about files that are not where a build file looks for them."""
PAGES = (".md", ".rst")
MAX_PAGES = 200
COPIES = regex(r"(?i)\b(?:cop(?:y|ied)|move|replace|paste|overwrite|cp|mv)\b")
COPIED = regex(r"\bpackage\.xml\b|\bCMakes?Lists?\b|\bsetup\.py\b|\w\.(?:py|cpp|hpp|msg|srv|action)\b")
MAKES = regex(r"\bros2[ \t]+pkg[ \t]+create\b")
WHY = "; a page has people copy these files into a package that `ros2 pkg create` makes"


def as_it_lies(results: RuleResults, files: PackageFiles, name: str) -> RuleResults:
    """Return the results of a package with an info for what is missing in a folder that only holds files to copy."""
    is_missing = any(isinstance(each, Finding) and each.code in OF_MISSING and each.is_loud for each in results)
    if not is_missing or not is_flat(files, name) or not any(has_copied(text, name) for text in pages(files)):
        return results
    return as_infos(results, OF_MISSING, lambda _: WHY)


def is_flat(files: PackageFiles, name: str) -> bool:
    """Return whether a package has none of the folders that `ros2 pkg create` makes, but code next to package.xml."""
    made = ("src/", "include/", f"{name}/", "resource/")
    code = (".cpp", ".hpp", ".py", ".msg", ".srv", ".action")
    is_code = (path.endswith(code) and path != "setup.py" for path in files.paths if "/" not in path)
    return not any(path.startswith(made) for path in files.paths) and any(is_code)


def pages(files: PackageFiles) -> list[str]:
    """Return the texts of the pages of the repository: an earlier step of a course may introduce the package."""
    whole = PackageFiles(files.whole) if files.whole is not None else files
    return [whole.readable_text(path) for path in whole.every if path.endswith(PAGES)][:MAX_PAGES]


def has_copied(text: str, name: str) -> bool:
    """Return whether a page has people make a package of a name, or names it where it has them copy files."""
    own = re.compile(rf"(?<![\w-]){re.escape(name)}(?![\w-])")
    lines = text.replace("\\\n", " ").split("\n") if own.search(text) else []
    return any(
        own.search(line) and (MAKES.search(line) or (COPIES.search(line) and COPIED.search(line))) for line in lines
    )
