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


SPACED = lines("x", tag="buildtool_depend") + "\n" + lines("t", tag="test_depend") + "\n"


def test_a_new_kind_is_parted_by_a_blank_line_where_the_others_are() -> None:
    new = lines("a", "b") + "\n" + lines("t", tag="test_depend")
    assert added("\n" + SPACED, "b", "a") == "\n" + lines("x", tag="buildtool_depend") + "\n" + new + "\n"
    assert added("\n" + lines("t", tag="test_depend") + "\n", "b", "a") == "\n" + new + "\n"


def test_a_new_kind_is_parted_by_nothing_where_two_kinds_are_neighbours() -> None:
    tight = "\n" + lines("x", tag="depend") + lines("t", tag="test_depend") + "\n"
    assert added(tight, "a", tag="build_depend") == tight.replace(
        "  <depend>", lines("a", tag="build_depend") + "  <depend>"
    )
    grouped = "\n" + lines("x", tag="depend") + "  <member_of_group>g</member_of_group>\n\n"
    assert added(grouped, "a") == grouped.replace("  <member", lines("a") + "  <member")


def test_above_the_comment_of_the_next_kind() -> None:
    note = "  <!-- Only for tests,\n       and optional -->\n  <!-- really -->\n"
    assert added(note + lines("t", tag="test_depend"), "a") == lines("a") + note + lines("t", tag="test_depend")
    far = note + "\n" + lines("t", tag="test_depend")
    assert added(far, "a") == note + "\n" + lines("a") + lines("t", tag="test_depend")


def test_an_element_in_a_comment_is_no_heading() -> None:
    first, second = lines("d", "b") + "  <!-- <exec_depend>x</exec_depend> -->\n", lines("c", "e", "f")
    assert added(first + second, "d") == first + lines("c", "d", "e", "f")
