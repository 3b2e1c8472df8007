"""YAML with the place of everything, and with aliases replaced by what they stand for."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rospkg_cli.checks.read_sentences import what_is_wrong
from rospkg_cli.languages.yaml.aliases import read_resolved
from rospkg_cli.languages.yaml.nodes import MappingNode, ScalarNode, SequenceNode, YamlNode, documents
from rospkg_cli.source import Source, Span
from rospkg_cli.unreadable import UnreadableError

PIECES = [
    "a",
    ": ",
    "- ",
    "\n",
    "  ",
    "&x ",
    "*x",
    "'",
    '"',
    "[",
    "]",
    "{",
    "}",
    ", ",
    "!!str ",
    "|\n",
    "---\n",
    "#",
    "é",
]
TEXTS = st.one_of(st.text(max_size=40), st.lists(st.sampled_from(PIECES), max_size=30).map("".join))


def source(text: str) -> Source:
    return Source("a.yaml", text)


def plain(node: YamlNode | None) -> object:
    match node:
        case MappingNode():
            return {plain(key): plain(value) for key, value in node.entries}
        case SequenceNode():
            return [plain(item) for item in node.items]
        case ScalarNode():
            return node.text
        case _:
            return node


@pytest.mark.parametrize(
    "text, shown, exact",
    [
        ("a b # c", "a b", True),
        ("'a b'", "a b", True),
        ('"a\\tb"', "a\\tb", False),
        ("&x 'a'", "a", True),
        ("!!str 1", "1", True),
        ("|\n  a\n", "a\n", True),
        ("a\n  b", "a\n  b", False),
    ],
)
def test_a_scalar_knows_where_its_text_stands(text: str, shown: str, exact: bool) -> None:
    (node,) = documents(source(text))
    assert isinstance(node, ScalarNode)
    assert (source(text).slice(node.located.span), node.located.is_exact) == (shown, exact)
    assert node.located.text == node.text


def test_aliases_are_replaced() -> None:
    found = read_resolved(source("a: &x [1, &y {b: c}]\nd: *x\ne: [*y, *x]\n"))
    assert plain(found) == {"a": ["1", {"b": "c"}], "d": ["1", {"b": "c"}], "e": [{"b": "c"}, ["1", {"b": "c"}]]}
    assert read_resolved(source("# nothing\n")) is None


@pytest.mark.parametrize(
    "text, place, why",
    [
        ("a: *x\n", "*x", "undefined alias 'x'"),
        ("a: 1\n---\nb: 2\n", "b", "another one begins here"),
        ("a: &x [*x]\n", "", "nested too deeply"),
        ("a: [\n", "", "not valid YAML"),
    ],
)
def test_what_is_not_one_document_is_refused(text: str, place: str, why: str) -> None:
    with pytest.raises(UnreadableError) as raised:
        read_resolved(source(text))
    assert why in what_is_wrong(raised.value.unreadable)
    assert place in source(text).slice(raised.value.unreadable.span)


@given(TEXTS)
def test_any_text_can_be_read_or_is_refused(text: str) -> None:
    place = Span(0, 0)
    try:
        read_resolved(source(text))
    except UnreadableError as error:
        place = error.unreadable.span
    assert 0 <= place.start <= place.end <= len(text)
