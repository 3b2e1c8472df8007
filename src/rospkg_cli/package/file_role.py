"""The role of a file of a package, by its path: folders decide, a name like `test_utils` does not."""

from __future__ import annotations

from typing import Literal

from ..lazy_regex import regex

Role = Literal["run", "launch", "test", "aside"]
"""Used by what is installed; by a launch file; by tests; by neither (docs, tools, setup.py)."""

TESTS = frozenset("test tests unit_test unit_tests integration_test integration_tests".split())
ASIDE = frozenset("doc docs cmake tools third_party thirdparty vendor vendored external templates template".split())
LAUNCH = regex(r"(^|/)launch(es)?/|[._]launch\.(py|xml|ya?ml)$|\.launch$")
ASIDE_ANYWHERE = frozenset({"third_party", "vendor", "templates", "template"})
NOT_INSTALLED = frozenset({"setup.py", "conf.py"})


def role_of(path: str) -> Role:
    """Return the role of a file by its path."""
    *folders, name = path.split("/")
    if not TESTS.isdisjoint(folders) or name == "conftest.py":
        return "test"
    if (folders or [name])[0] in ASIDE or path in NOT_INSTALLED or not ASIDE_ANYWHERE.isdisjoint(folders):
        return "aside"
    return "launch" if LAUNCH.search(path) else "run"
