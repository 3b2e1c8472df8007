"""Where a dependency is written: in its block, by the order of its like, and under no comment of others."""

from __future__ import annotations

import pytest

from rospkg_cli.edits.manifest import add_dependencies, add_dependency
from rospkg_cli.example import manifest
from rospkg_cli.finding import Edit
from rospkg_cli.package.manifest import manifest_of
from rospkg_cli.source import Source


def added(body: str, *names: str, tag: str = "exec_depend") -> str:
    """Return the lines of dependencies with some more."""
    text = manifest("  <HERE/>\n").replace("  <HERE/>\n", body)
    found = manifest_of(Source("package.xml", text))
    edits: tuple[Edit, ...] = add_dependencies(found, ((tag, name) for name in names))
    for edit in sorted(edits, key=lambda each: each.span, reverse=True):
        text = text[: edit.span.start] + edit.text + text[edit.span.end :]
    start = text.index("</license>\n") + len("</license>\n")
    return text[start : text.index("  <export>")]


def lines(*names: str, tag: str = "exec_depend") -> str:
    return "".join(f"  <{tag}>{name}</{tag}>\n" for name in names)


@pytest.mark.parametrize(
    "there, name, after",
    [
        (("b", "d"), "a", ("a", "b", "d")),
        (("b", "d"), "c", ("b", "c", "d")),
        (("b", "d"), "e", ("b", "d", "e")),
        (("d", "b"), "c", ("d", "b", "c")),
    ],
)
def test_in_order_where_there_is_one(there: tuple[str, ...], name: str, after: tuple[str, ...]) -> None:
    assert added(lines(*there), name) == lines(*after)


def test_before_the_first_of_its_block_and_not_behind_the_block_above() -> None:
    above = lines("z", tag="depend") + "\n"
    assert added(above + lines("b", "c"), "a") == above + lines("a", "b", "c")


def test_a_comment_heads_the_lines_of_others() -> None:
    plain, headed = lines("b", "d"), "\n  <!-- Arms -->\n" + lines("c", "e", "f")
    assert added(plain + headed, "a") == lines("a", "b", "d") + headed
    assert added(headed + "\n" + plain, "e") == headed + "\n" + lines("b", "d", "e")


def test_under_the_only_comment() -> None:
    headed = "  <!-- Needed -->\n"
    assert added(headed + lines("b"), "c") == headed + lines("b", "c")


def test_the_block_with_most_of_a_tag() -> None:
    first, second = lines("a") + "\n", lines("c", "d")
    assert added(first + second, "b") == first + lines("b", "c", "d")


def test_a_comment_in_the_same_line_ends_no_block() -> None:
    first = "  <exec_depend>b</exec_depend>  <!-- the driver -->\n"
    assert added(first + lines("d"), "c") == first + lines("c", "d")


def test_the_first_of_its_tag_comes_behind_what_is_before_it_in_order() -> None:
    body = lines("x", tag="depend") + lines("t", tag="test_depend")
    assert added(body, "a") == lines("x", tag="depend") + lines("a") + lines("t", tag="test_depend")
    assert added(lines("t", tag="test_depend"), "a") == lines("a") + lines("t", tag="test_depend")


def test_the_first_dependency_of_all() -> None:
    assert added("", "a") == lines("a")


def test_several_of_one_place_are_one_edit() -> None:
    found = manifest_of(Source("package.xml", manifest(lines("d"))))
    (edit,) = add_dependencies(found, [("exec_depend", "b"), ("exec_depend", "a")])
    assert edit.text == "<exec_depend>a</exec_depend>\n  <exec_depend>b</exec_depend>\n  "
    assert add_dependency(found, "exec_depend", "a").span == edit.span
