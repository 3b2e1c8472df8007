"""The XML reader: exact spans for what is well formed, one exact place and a plain reason for what is not."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rospkg_cli.checks.read_sentences import what_is_wrong
from rospkg_cli.languages.xml.parser import MAX_DEPTH, Document, read_xml
from rospkg_cli.source import Source, Span
from rospkg_cli.testing import lint_files
from rospkg_cli.unreadable import Unreadable, UnreadableError

NAME = st.from_regex(r"[a-z][a-z_]{0,6}", fullmatch=True)
TEXT = st.text(
    st.characters(codec="utf-8", exclude_characters="<>&\r\x00", exclude_categories=["Cc", "Cs"]), max_size=12
)
BLANK = st.sampled_from(["", " ", "\n  ", "\t"])


@st.composite
def elements(draw: st.DrawFn, depth: int = 3) -> str:
    tag = draw(NAME)
    names = draw(st.lists(NAME, unique=True, max_size=3))
    quotes = [draw(st.sampled_from("\"'")) for _ in names]
    values = [draw(TEXT).replace(quote, "") for quote in quotes]
    attributes = "".join(
        f"{draw(BLANK) or ' '}{n}{draw(BLANK)}={q}{v}{q}" for n, q, v in zip(names, quotes, values, strict=True)
    )
    inside = draw(
        st.lists(
            st.one_of(
                TEXT,
                TEXT.map(lambda t: "<!--" + t.replace("-", "") + "-->"),
                st.just("&lt;&#233;"),
                *([elements(depth=depth - 1)] if depth else []),
            ),
            max_size=4,
        )
    )
    if not inside and draw(st.booleans()):
        return f"<{tag}{attributes}{draw(BLANK)}/>"
    return f"<{tag}{attributes}{draw(BLANK)}>{''.join(inside)}</{tag}{draw(BLANK)}>"


def read(text: str) -> Document:
    return read_xml(Source("package.xml", text))


def complaint(text: str) -> tuple[Span, str]:
    with pytest.raises(UnreadableError) as caught:
        read(text)
    return caught.value.unreadable.span, what_is_wrong(caught.value.unreadable)


@given(elements())
def test_spans_are_exact_and_nested(text: str) -> None:
    source = Source("package.xml", text)
    document = read_xml(source)
    for element in document.root.walk():
        whole = source.slice(element.span)
        assert whole.startswith("<" + element.tag)
        assert whole.endswith(">")
        assert source.slice(element.open).startswith("<" + element.tag)
        assert source.slice(element.open).endswith(">")
        assert read(whole).root.tag == element.tag
        at = element.inner.start
        for node in element.nodes:
            assert at <= node.span.start < node.span.end <= element.inner.end
            at = node.span.end
        for name, attribute in element.attributes.items():
            assert source.slice(attribute.span).startswith(name)
            assert source.slice(attribute.value_span) in source.slice(attribute.span)
            if "&" not in attribute.value:
                assert attribute.value == source.slice(attribute.value_span).replace("\n", " ").replace("\t", " ")


@given(elements())
def test_children_comments_and_text_tile_an_element(text: str) -> None:
    source = Source("package.xml", text)
    for element in read_xml(source).root.walk():
        rest, at = "", element.inner.start
        for node in element.nodes:
            rest += source.text[at : node.span.start]
            at = node.span.end
        rest += source.text[at : element.inner.end]
        assert rest.replace("&lt;", "<").replace("&#233;", "é").strip() == element.text


def refusal(text: str) -> Unreadable | None:
    try:
        read(text)
    except UnreadableError as error:
        return error.unreadable
    return None


@given(st.text(max_size=60))
def test_any_text_is_read_or_refused(text: str) -> None:
    found = refusal(text)
    if found:
        assert 0 <= found.span.start <= found.span.end <= len(text)
        assert what_is_wrong(found).startswith("`package.xml`")


@settings(max_examples=150)
@given(
    elements(), st.integers(0, 400), st.sampled_from(["", "<", "</", ">", "&", "&x;", '"', "<!--", "]]>", "\x00", "é"])
)
def test_a_damaged_text_is_read_or_refused_within_it(text: str, at: int, what: str) -> None:
    damaged = text[: at % (len(text) + 1)] + what + text[at % (len(text) + 1) + 1 :]
    found = refusal(damaged)
    if found:
        assert 0 <= found.span.start <= found.span.end <= len(damaged)


@pytest.mark.parametrize(
    "text, marked, says",
    [
        ("", "", "the file is empty"),
        ("<a><b></a>", "a", "`<b>` is closed by `</a>`"),
        ("<a>\n  <b>\n", "<", "`<b>` is never closed"),
        ("<a>x & y</a>", " ", "a lone `&`; write `&amp;`"),
        ("<a>a < b</a>", " ", "a `<` that begins no tag, inside `<a>`; write `&lt;`"),
        ("<a/><b/>", "<", "something follows after the end of the root element"),
        ("<a></a>\n</a>", "/", "something follows after the end of the root element"),
        ("</a>", "/", "an unexpected character"),
        ("<a>\n<<<<<<< HEAD\n</a>", "<", "holds a merge conflict (`<<<<<<<`); resolve it"),
        ("\n<?xml version='1.0'?><a/>", "<", "must be the very first"),
        ("<a>é<b></c></a>", "c", "`<b>` is closed by `</c>`"),
        ('<a x:y="1"/>', "<", "the prefix of `x:y` is declared nowhere (`xmlns:x`)"),
        ('<a b="1" b="2"/>', "b", "duplicate attribute"),
        ("<a>&foo;</a>", "&", "undefined entity"),
    ],
)
def test_what_is_wrong_is_said_where_it_is(text: str, marked: str, says: str) -> None:
    span, message = complaint(text)
    assert says in message
    assert text[span.start : span.end] == marked


@pytest.mark.parametrize(
    "doctype",
    [
        '<!DOCTYPE a [<!ENTITY b "c">]>',
        '<!DOCTYPE a SYSTEM "file:///etc/passwd">',
        '<!DOCTYPE a [<!ENTITY b SYSTEM "x">]>',
    ],
)
def test_document_types_and_entities_are_refused(doctype: str) -> None:
    span, message = complaint(f'<?xml version="1.0"?>\n{doctype}<a>&b;</a>')
    assert "has a DOCTYPE" in message
    assert span.start == 22


def test_depth_is_bounded() -> None:
    assert read("<a>" * MAX_DEPTH + "</a>" * MAX_DEPTH).root.tag == "a"
    assert "nested deeper" in complaint("<a>" * 100_000)[1]


def test_wide_documents_are_read_in_linear_time() -> None:
    """Counted in handler calls, not in seconds: a quadratic reader would not come to the end."""
    document = read("<a>" + "é<b c='ü'/>" * 20_000 + "</a>")
    assert len(document.root.children) == 20_000
    assert document.source.slice(document.root.children[-1].span) == "<b c='ü'/>"


def test_declared_prefixes_are_bound_below() -> None:
    assert read('<a xmlns:x="u"><x:b x:c="1"/></a>').root.children[0].tag == "x:b"
    assert "declared nowhere" in complaint('<a><b xmlns:x="u"/><x:c/></a>')[1]


@pytest.mark.parametrize("encoding", ["utf-32", "utf-32-le", "utf-32-be"])
def test_utf_32_is_one_sentence(encoding: str) -> None:
    data = '<?xml version="1.0"?>\n<?a b?>\n<!-- c --><package/>\n'.encode(encoding)
    results = lint_files({"package.xml": data}, ["RPK001"])
    assert not results.crashes
    assert [f.code for f in results.findings] == ["RPK001"]
    assert "save it as UTF-8" in results.findings[0].message
