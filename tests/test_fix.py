"""The engine's core of fixing: operations on spans and files, equal ones once, rounds, taking back."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rospkg_cli.engine.fixing.apply import Changes, Round, apply_fixes, touch
from rospkg_cli.finding import Chmod, Create, Delete, Edit, Fix, Move, Operation
from rospkg_cli.source import Span
from rospkg_cli.tree import MemoryTree, TreeEntry


def texts(changes: Changes) -> dict[str, str | None]:
    return {path: entry.text.text if entry else None for path, entry in changes.items()}


def edit(start: int, end: int, text: str, path: str = "a.txt") -> Edit:
    return Edit(path, Span(start, end), text)


def test_equal_operations_are_applied_once() -> None:
    tree = MemoryTree.of({"a.txt": "one\n"})
    same = edit(4, 4, "two\n")
    changes, taken = apply_fixes(tree, [Fix("x", (same,)), Fix("y", (same,))])
    assert texts(changes) == {"a.txt": "one\ntwo\n"}
    assert len(taken) == 2


def test_insertions_at_one_place_keep_the_order_of_the_findings() -> None:
    tree = MemoryTree.of({"a.txt": "()"})
    changes, _ = apply_fixes(tree, [Fix("b", (edit(1, 1, "b"),)), Fix("a", (edit(1, 1, "a"),))])
    assert texts(changes) == {"a.txt": "(ba)"}


@pytest.mark.parametrize("other", [edit(2, 5, "x"), edit(3, 3, "x"), edit(4, 6, "x"), Delete("a.txt")])
def test_what_touches_waits(other: Edit | Delete) -> None:
    tree = MemoryTree.of({"a.txt": "0123456789"})
    changes, taken = apply_fixes(tree, [Fix("first", (edit(3, 4, "-"),)), Fix("second", (other,))])
    assert [fix.title for fix in taken] == ["first"]
    assert texts(changes) == {"a.txt": "012-456789"}


@pytest.mark.parametrize(
    "first", [Delete("a.txt"), Create("a.txt", "x"), Move("a.txt", "b.txt"), Move("b.txt", "a.txt")]
)
@pytest.mark.parametrize("other", [edit(2, 5, "x"), Chmod("a.txt", True), Create("a.txt", "y"), Move("c.txt", "a.txt")])
def test_a_file_that_is_claimed_whole_is_left_to_one_fix(first: Operation, other: Operation) -> None:
    tree = MemoryTree.of({"a.txt": "0123456789", "b.txt": "b", "c.txt": "c"})
    _, taken = apply_fixes(tree, [Fix("first", (first,)), Fix("second", (other,))])
    assert [fix.title for fix in taken] == ["first"]


def test_a_fix_is_applied_whole_or_not_at_all() -> None:
    tree = MemoryTree.of({"a.txt": "0123", "b.txt": "0123"})
    first = Fix("first", (edit(0, 1, "-"),))
    both = Fix("both", (edit(0, 1, "x"), edit(0, 1, "x", "b.txt")))
    changes, taken = apply_fixes(tree, [first, both])
    assert [fix.title for fix in taken] == ["first"]
    assert texts(changes) == {"a.txt": "-123"}


def test_operations_on_whole_files() -> None:
    tree = MemoryTree.of({"old": "x", "gone": "y", "script": "z"})
    fix = Fix("all", (Create("new", "text\n"), Delete("gone"), Move("old", "moved"), Chmod("script", True)))
    changes, _ = apply_fixes(tree, [fix])
    assert texts(changes) == {"new": "text\n", "gone": None, "old": None, "moved": "x", "script": "z"}
    assert changes["script"] == TreeEntry("file", b"z", 0o755)


@pytest.mark.parametrize(
    "before, after",
    [
        (b"one\r\ntwo\r\n", b"1\r\nnew\r\ntwo\r\n"),
        (b"\xef\xbb\xbfone\ntwo\n", b"\xef\xbb\xbf1\nnew\ntwo\n"),
        ("one\ntwö\n".encode("utf-16"), None),
        (b"one\rtwo\nx\r\n", b"1\nnew\rtwo\nx\r\n"),
    ],
)
def test_encoding_mark_and_line_ends_stay(before: bytes, after: bytes | None) -> None:
    tree = MemoryTree.of({"a.txt": before})
    changes, _ = apply_fixes(tree, [Fix("x", (edit(0, 3, "1\nnew"),))])
    entry = changes["a.txt"]
    assert entry is not None
    assert entry.data == (after or "1\nnew\ntwö\n".encode("utf-16"))


def test_the_mode_stays() -> None:
    tree = MemoryTree.of({"a.txt": TreeEntry("file", b"one\n", 0o775)})
    changes, _ = apply_fixes(tree, [Fix("x", (edit(0, 3, "1"),))])
    assert changes["a.txt"] == TreeEntry("file", b"1\n", 0o775)


@given(st.lists(st.tuples(st.integers(0, 30), st.integers(0, 4), st.sampled_from(["", "x"])), max_size=12))
def test_neighbours_are_enough_to_see_what_touches(spans: list[tuple[int, int, str]]) -> None:
    """Against the plain definition: each new edit compared with all that were taken."""
    round_, taken = Round(), list[Edit]()
    for start, length, text in spans:
        new = edit(start, start + length, text)
        free = new in taken or not any(touch(new.span, other.span) for other in taken)
        assert round_.take(Fix("x", (new,))) == free
        if free and new not in taken:
            taken.append(new)
