"""The role of a file of a package, by its path: folders decide, a name like `test_utils` does not."""

from __future__ import annotations

import re
from functools import lru_cache
from typing import Literal

from ..lazy_regex import regex

Role = Literal["run", "launch", "test", "aside"]
"""Used by what is installed; by a launch file; by tests; by neither (docs, tools, setup.py)."""

TESTS = frozenset("test tests unit_test unit_tests integration_test integration_tests".split())
ASIDE = frozenset("doc docs cmake tools third_party thirdparty vendor vendored external templates template".split())
LAUNCH = regex(r"(^|/)launch(es)?/|[._]launch\.(py|xml|ya?ml)$|\.launch$")
ASIDE_ANYWHERE = frozenset({"vendor", "templates", "template"})
OF_OTHERS = regex(r"(?:third|3rd)[ _-]?part(?:y|ies)", re.IGNORECASE)
"""Folders for copies of what others wrote, with their own tests, which no build of the package compiles."""
NOT_INSTALLED = frozenset({"setup.py", "conf.py"})
UNUSED = r"un-?used|disused|not[ _-]?(?:in[ _-]?)?used?|(?:do[ _-]?not|don'?t)[ _-]?use"
"""Words in the name of a folder or file that say that it is not used, next to any other words."""
LEFT_BEHIND = rf"depr[ei]cated|obsolete|archived|discarded|outdated|abandoned|wip|{UNUSED}"
"""What people write before or behind the name of a file, too, and what no robot or node is called."""
GONE = rf"legacy|archive|attic|retired|{LEFT_BEHIND}"
PAST = r"old|backups?|bak|(?:tmp|temp)[_-]old|junk|broken|not[ _-]?working"
ENDS = r"old|backups?|bak"
"""What a folder called after what it holds may end with (`urdf_backup`)."""
KINDS = r"files|code|pkgs|packages|nodes|scripts|versions?|stuff|models?|launch|urdfs?|configs?|mesh(?:es)?|worlds?|src"
COPIED = r".* copy(?: \d+)?|.* - copy(?: \(\d+\))?"
"""How desktops call a copy of a folder: `urdf copy 2`, `urdf - Copy (2)`."""
LEFT = regex(
    rf"[_.-]*(?:(?:{GONE}|{PAST})(?:[ _-](?:{KINDS}))?|(?:{KINDS})[ _-](?:{GONE}|{ENDS})|"
    rf"(?:{UNUSED})[ _-].*|.*[_.-](?:{UNUSED}))[_.-]*|{COPIED}",
    re.IGNORECASE,
)
"""Folders for what is no longer used; without words that the task of a robot may have (`trash`, `garbage`)."""
LEFT_FILE = regex(
    rf".*[_.-](?:legacy|old|backup|bak|orig|copy|{LEFT_BEHIND})|(?:legacy|{LEFT_BEHIND})(?:[_.-].*)?",
    re.IGNORECASE | re.DOTALL,
)
COPY = regex(r" copy(?: \d+)?\.", re.IGNORECASE)
"""How editors and desktops call a copy of a file: `a.launch copy 2.py`."""


@lru_cache(maxsize=4096)
def role_of(path: str) -> Role:
    """Return the role of a file by its path; most readers and rules ask for it."""
    *folders, name = path.split("/")
    if "part" in path.lower() and any(map(OF_OTHERS.fullmatch, folders)):
        return "aside"
    if not TESTS.isdisjoint(folders) or name == "conftest.py":
        return "test"
    if (folders or [name])[0] in ASIDE or path in NOT_INSTALLED or not ASIDE_ANYWHERE.isdisjoint(folders):
        return "aside"
    return "launch" if "launch" in path and LAUNCH.search(path) else "run"


def is_set_aside(path: str) -> bool:
    """Return whether a file or folder is in a folder for what is no longer used, or is a file with such a name."""
    *folders, last = path.split("/")
    is_left = LEFT_FILE.fullmatch(last.partition(".")[0]) or COPY.search(last)
    return is_left is not None or any(LEFT.fullmatch(each) for each in folders)
