"""Substitutions as the XML and YAML frontends read them."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rospkg_cli.languages.located_text import LocatedText
from rospkg_cli.package.launch.substitution import MAX_DEPTH, SubstitutionError, parse_text
from rospkg_cli.package.launch.text import LaunchText, Literal
from rospkg_cli.source import Span


def parse(text: str) -> LaunchText:
    return parse_text(LocatedText(text, Span(0, len(text))))


def plain(text: LaunchText) -> list:
    """Return literals as text, substitutions as [name, arguments…]."""
    return [p.text if isinstance(p, Literal) else [p.name, *map(plain, p.arguments)] for p in text.parts]


@pytest.mark.parametrize(
    "text, parts",
    [
        ("", []),
        ("a $5 (b)", ["a $5 (b)"]),
        ("$(var x)", [["var", ["x"]]]),
        ("a/$(var x)/b", ["a/", ["var", ["x"]], "/b"]),
        ("$(find-pkg-share $(var p))/x", [["find-pkg-share", [["var", ["p"]]]], "/x"]),
        ("$(eval '1 + 2')", [["eval", ["1 + 2"]]]),
        ("$(eval '\\'$(var x)\\' == \\'a\\'')", [["eval", ["'", ["var", ["x"]], "' == 'a'"]]]),
        ('$(command "xacro $(var f)" warn)', [["command", ["xacro ", ["var", ["f"]]], ["warn"]]]),
        ("$(env HOME $(dirname))", [["env", ["HOME"], [["dirname"]]]]),
        ("\\$(var x)", ["$(var x)"]),
        ("$(eval 1\\(2\\))", [["eval", ["1(2)"]]]),
        ("$(var a$b)", [["var", ["a$b"]]]),
    ],
)
def test_what_the_grammar_takes(text: str, parts: list) -> None:
    assert plain(parse(text)) == parts


@pytest.mark.parametrize(
    "text, at",
    [
        ("$(var x", 0),
        ("a $( var x)", 4),
        ("$()", 2),
        ("$(var x )", 8),
        ("$(var  x)", 6),
        ("$(eval 1 + (2))", 11),
        ("$(eval 'a)", 7),
        ("$(var x'y')", 7),
        ("$(" * 40, 2),
    ],
)
def test_what_it_refuses_and_where(text: str, at: int) -> None:
    with pytest.raises(SubstitutionError) as caught:
        parse(text)
    assert caught.value.at == at


def test_each_part_knows_its_place() -> None:
    text = "a/$(find-pkg-share demo)/b"
    found = parse(text)
    assert [text[p.span.start : p.span.end] for p in found.parts] == ["a/", "$(find-pkg-share demo)", "/b"]
    assert [text[s.arguments[0].span.start : s.arguments[0].span.end] for s in found.substitutions()] == ["demo"]


def test_a_value_with_references_has_its_own_place_only() -> None:
    found = parse_text(LocatedText("a&$(var x)", Span(10, 30), is_exact=False))
    assert {part.span for part in found.parts} == {Span(10, 30)}


@given(st.text(alphabet="$()'\"\\ abv\n", max_size=40))
def test_any_text_is_read_or_refused_and_the_spans_tile_it(text: str) -> None:
    try:
        found = parse(text)
    except SubstitutionError as error:
        found = None
        at = error.at
    if found is None:
        assert 0 <= at <= len(text)
    else:
        assert "".join(text[p.span.start : p.span.end] for p in found.parts) == text


def nested(times: int) -> str:
    return "$(a " * times + "x" + ")" * times


def test_substitutions_inside_of_each_other_have_a_bound() -> None:
    deepest = MAX_DEPTH + 1
    found = plain(parse(nested(deepest)))
    for _ in range(deepest):
        [[name, found]] = found
        assert name == "a"
    assert found == ["x"]
    for times in (deepest + 1, 5000):
        with pytest.raises(SubstitutionError, match="SUBSTITUTION_DEPTH"):
            parse(nested(times))
