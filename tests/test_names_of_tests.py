"""pytest imports test files by their bare name: two of one name hide each other."""

from __future__ import annotations

from collections import Counter
from pathlib import Path


def test_no_two_test_files_have_one_name() -> None:
    names = Counter(path.name for path in Path(__file__).parent.rglob("test_*.py") if "corpus" not in path.parts)
    assert [name for name, count in names.items() if count > 1] == []
