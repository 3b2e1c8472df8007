"""Texts and attributes that edits write into package.xml, against the standard library's own."""

from __future__ import annotations

from xml.sax import saxutils

from hypothesis import given
from hypothesis import strategies as st

from rospkg_cli.edits.manifest_tags import escape, quoted

TEXTS = st.text("ab&<>;#\"'\n\r\t é")


@given(TEXTS)
def test_texts_are_escaped_as_the_standard_library_does(text: str) -> None:
    assert escape(text) == saxutils.escape(text)
    assert quoted(text) == saxutils.quoteattr(text)
