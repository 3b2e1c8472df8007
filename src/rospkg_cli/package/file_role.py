"""The role of a file of a package, by its path: folders decide, a name like `test_utils` does not."""

from __future__ import annotations

from pathlib import PurePosixPath
from typing import Literal

from ..lazy_regex import regex

Role = Literal["run", "launch", "test", "aside"]
"""Used by what is installed; by a launch file; by tests; by neither (docs, tools, setup.py)."""

TESTS = frozenset("test tests unit_test unit_tests integration_test integration_tests".split())
ASIDE = frozenset("doc docs cmake tools third_party thirdparty vendor vendored external templates template".split())
LAUNCH = regex(r"(^|/)launch(es)?/|[._]launch\.(py|xml|ya?ml)$|\.launch$")
NOT_INSTALLED = frozenset({"setup.py", "conf.py"})


def role_of(path: str) -> Role:
    """Return the role of a file by its path."""
    where = PurePosixPath(path)
    folders = set(where.parts[:-1])
    if folders & TESTS or where.name == "conftest.py":
        return "test"
    if where.parts[0] in ASIDE or path in NOT_INSTALLED or folders & {"third_party", "vendor", "templates", "template"}:
        return "aside"
    return "launch" if LAUNCH.search(path) else "run"
