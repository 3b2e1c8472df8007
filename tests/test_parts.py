"""Packages are spread over processes so that each has as much to read."""

from __future__ import annotations

from rospkg_cli.engine.run.parts import parts_of, sizes_of

FILES = ["a/x.py", "a/b/x.py", "a/b/y.cpp", "a/b/z.md", "c/d/e.yaml", "c/package.xml", "x.py", "no/x.py"]


def test_a_file_counts_for_the_innermost_package() -> None:
    assert sizes_of(["a", "a/b", "c"], FILES) == {"a": 1, "a/b": 2, "c": 2}
    assert sizes_of(["", "c"], FILES) == {"": 5, "c": 2}


def test_the_largest_come_first_and_the_order_stays() -> None:
    files = [
        f"{folder}/{number}.py"
        for folder, count in zip("abcde", (1, 9, 4, 5, 2), strict=True)
        for number in range(count)
    ]
    assert parts_of("abcde", files, 2) == [("b", "e"), ("a", "c", "d")]
    assert parts_of("abcde", files, 9) == [("b",), ("d",), ("c",), ("e",), ("a",)]
    assert parts_of("abcd", [], 2) == [("a", "c"), ("b", "d")]
    assert parts_of("", [], 2) == []
