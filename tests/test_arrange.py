"""Putting the children of <package> in order: every piece is kept, comments and blank lines stand where they belong."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rospkg_cli.edits.manifest_items import items_of
from rospkg_cli.edits.reorder import canonical_order, reorder, schema_order
from rospkg_cli.engine.fixing.apply import edited
from rospkg_cli.package.manifest import Manifest, manifest_of
from rospkg_cli.source import Source
from rospkg_cli.tree import TreeEntry


def arranged(text: str, order: Callable[[Manifest], Callable]) -> str:
    manifest = manifest_of(Source("package.xml", text))
    return edited(TreeEntry("file", text.encode()), reorder(manifest, order(manifest))).text.text


def package(*lines: str) -> str:
    return "\n".join(["<package>", *(f"  {line}" if line else "" for line in lines), "</package>", ""])


CASES = {
    "an author before the license": (
        ["<author>A</author>", "<license>L</license>", "", "<depend>a</depend>"],
        ["<license>L</license>", "<author>A</author>", "", "<depend>a</depend>"],
    ),
    "a paragraph keeps its blank line": (
        ["<license>L</license>", "", "<author>A</author>", "<url>u</url>", "", "<depend>a</depend>"],
        ["<license>L</license>", "", "<url>u</url>", "<author>A</author>", "", "<depend>a</depend>"],
    ),
    "tests behind the export": (
        ["<depend>a</depend>", "", "<export/>", "", "<test_depend>b</test_depend>", "<test_depend>c</test_depend>"],
        ["<depend>a</depend>", "", "<test_depend>b</test_depend>", "<test_depend>c</test_depend>", "", "<export/>"],
    ),
    "comments above and behind travel": (
        ["<!-- out -->", "<export/>", "<!-- why", "  so -->", "<depend>a</depend> <!-- tail -->"],
        ["<!-- why", "  so -->", "<depend>a</depend> <!-- tail -->", "<!-- out -->", "<export/>"],
    ),
    "a heading stays above its paragraph": (
        ["<license>L</license>", "", "<!-- Out -->", "", "<export/>", "", "<!-- In -->", "", "<depend>a</depend>"],
        ["<license>L</license>", "", "<!-- In -->", "", "<depend>a</depend>", "", "<!-- Out -->", "", "<export/>"],
    ),
    "an unknown tag stays behind the one before it": (
        ["<author>A</author>", "<bogus/>", "<license>L</license>"],
        ["<license>L</license>", "<author>A</author>", "<bogus/>"],
    ),
}


@pytest.mark.parametrize("before, after", CASES.values(), ids=CASES.keys())
def test_in_the_order_of_the_schema(before: list[str], after: list[str]) -> None:
    assert arranged(package(*before), schema_order) == package(*after)


def test_in_canonical_order() -> None:
    before = [
        "<buildtool_depend>x</buildtool_depend>", "", "<!-- deps -->", "", "<!-- y -->", "<depend>y</depend>",
        "<depend>c</depend>", "", "<depend>b</depend>", "<exec_depend>q</exec_depend>",
    ]  # fmt: skip
    after = [
        "<buildtool_depend>x</buildtool_depend>", "", "<!-- deps -->", "", "<depend>b</depend>", "<depend>c</depend>",
        "<!-- y -->", "<depend>y</depend>", "", "<exec_depend>q</exec_depend>",
    ]  # fmt: skip
    assert arranged(package(*before), canonical_order) == package(*after)


CANONICAL = {
    "conditions": (
        ['<depend condition="b">x</depend>', "<depend>x</depend>", '<depend condition="a">x</depend>'],
        ["<depend>x</depend>", '<depend condition="a">x</depend>', '<depend condition="b">x</depend>'],
    ),
    "one line": (
        ["<name>n</name>", "<exec_depend>b</exec_depend> <depend>a</depend>", "<version>1</version>"],
        ["<name>n</name>", "<version>1</version>", "<depend>a</depend>", "<exec_depend>b</exec_depend>"],
    ),
    "all in one line": (
        ["<name>n</name> <exec_depend>b</exec_depend> <depend>a</depend> <version>1</version>"],
        ["<name>n</name>", "<version>1</version>", "<depend>a</depend>", "<exec_depend>b</exec_depend>"],
    ),
    "two paragraphs": (
        [
            "<name>n</name>",
            "",
            "<exec_depend>b</exec_depend>",
            "",
            "",
            "<depend>c</depend>",
            "<depend>a</depend>",
            "<export/>",
        ],
        [
            "<name>n</name>",
            "",
            "",
            "<depend>a</depend>",
            "<depend>c</depend>",
            "",
            "<exec_depend>b</exec_depend>",
            "<export/>",
        ],
    ),
    "text": (
        ["<name>n</name>", "words", "<exec_depend>b</exec_depend>", "<depend>a</depend>"],
        ["<name>n</name>", "words", "<exec_depend>b</exec_depend>", "<depend>a</depend>"],
    ),
    "comment alone": (
        ["<exec_depend>b</exec_depend>", "<!-- x -->", "", "<!-- y -->", "<depend>a</depend>", "<!-- end -->"],
        ["<!-- y -->", "<depend>a</depend>", "<!-- x -->", "", "<exec_depend>b</exec_depend>", "<!-- end -->"],
    ),
    "groups": (
        [
            "<depend>b</depend>",
            "<exec_depend>a</exec_depend>",
            "",
            "<depend>a</depend>",
            "<test_depend>z</test_depend>",
            "<exec_depend>c</exec_depend>",
        ],
        [
            "<depend>a</depend>",
            "<depend>b</depend>",
            "<exec_depend>a</exec_depend>",
            "<exec_depend>c</exec_depend>",
            "",
            "<test_depend>z</test_depend>",
        ],
    ),
    "unknown first": (
        ["<bogus/>", "<version>1</version>", "<name>n</name>"],
        ["<bogus/>", "<name>n</name>", "<version>1</version>"],
    ),
    "heading": (
        [
            "<!-- Run -->",
            "<exec_depend>b</exec_depend>",
            "<exec_depend>a</exec_depend>",
            "",
            "<!-- Build -->",
            "<depend>c</depend>",
        ],
        [
            "<!-- Build -->",
            "<depend>c</depend>",
            "",
            "<exec_depend>a</exec_depend>",
            "<!-- Run -->",
            "<exec_depend>b</exec_depend>",
        ],
    ),
}


@pytest.mark.parametrize("before, after", CANONICAL.values(), ids=CANONICAL.keys())
def test_in_canonical_order_with_lines_and_comments(before: list[str], after: list[str]) -> None:
    assert arranged(package(*before), canonical_order) == package(*after)


@pytest.mark.parametrize("stray", ["words", "\u3000", "<?go on?>"])
def test_nothing_is_arranged_around_stray_text(stray: str) -> None:
    text = package("<author>A</author>", stray, "<license>L</license>")
    assert arranged(text, schema_order) == text


LINE = st.one_of(
    st.sampled_from(
        ["", "", "<!-- a -->", "<!-- b\n  c -->", "<export/>", "<license>L</license>", "<author>A</author>"]
    ),
    st.builds(
        lambda tag, name, tail: f"<{tag}>{name}</{tag}>{tail}",
        st.sampled_from(["depend", "exec_depend", "test_depend", "bogus"]),
        st.sampled_from("abc"),
        st.sampled_from(["", " <!-- t -->", "<url>u</url>"]),
    ),
)


def pieces(text: str) -> Counter[str]:
    """The children, each with the comments that are about it."""
    manifest = manifest_of(Source("package.xml", text))
    return Counter(manifest.source.slice(item.span) for item in items_of(manifest))


@given(st.lists(LINE, max_size=14), st.sampled_from([schema_order, canonical_order]))
def test_every_piece_is_kept_and_twice_is_once(lines: list[str], order: Callable[[Manifest], Callable]) -> None:
    text = package(*lines)
    once = arranged(text, order)
    assert pieces(once) == pieces(text)
    assert Counter(once.replace("\n  ", "")) == Counter(text.replace("\n  ", ""))
    if "<url>" not in text:
        assert Counter(once) == Counter(text)
    assert once.count("<!--") == text.count("<!--")
    assert arranged(once, order) == once
    after = manifest_of(Source("package.xml", once))
    keys = [order(after)(child) for child in after.root.children]
    assert keys == sorted(keys)
