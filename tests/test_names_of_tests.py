"""pytest imports test files by their bare name: two of one name hide each other."""

from __future__ import annotations

import re
from collections import Counter
from pathlib import Path


def test_no_test_imports_from_a_package_of_tests() -> None:
    """The folder is none: it is on the path where Python itself starts pytest, and not where `pytest` does."""
    files = Path(__file__).parent.rglob("*.py")
    asked = [path.name for path in files if re.search(r"^(from|import) tests\b", path.read_text("utf-8"), re.MULTILINE)]
    assert asked == []


def test_no_two_test_files_have_one_name() -> None:
    names = Counter(path.name for path in Path(__file__).parent.rglob("test_*.py") if "corpus" not in path.parts)
    assert [name for name, count in names.items() if count > 1] == []
