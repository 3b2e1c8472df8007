"""Bytes to text and back, for every encoding that is read."""

from __future__ import annotations

import codecs

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rospkg_cli.encoding import decode

BODY = '<?xml version="1.0" encoding="{}"?>\n<a>grün</a>\n'


@pytest.mark.parametrize(
    "declared, codec, bom",
    [
        ("UTF-8", "utf-8", b""),
        ("UTF-8", "utf-8", codecs.BOM_UTF8),
        ("UTF-16", "utf-16-le", codecs.BOM_UTF16_LE),
        ("UTF-16", "utf-16-be", codecs.BOM_UTF16_BE),
        ("UTF-16", "utf-16-le", b""),
        ("UTF-16LE", "utf-16-le", b""),
        ("ISO-8859-1", "iso-8859-1", b""),
        ("iso-8859-15", "iso-8859-15", b""),
        ("windows-1252", "cp1252", b""),
    ],
)
@pytest.mark.parametrize("newline", ["\n", "\r\n"])
def test_encodings_go_and_come_back(declared: str, codec: str, bom: bytes, newline: str) -> None:
    text = BODY.format(declared)
    data = bom + text.replace("\n", newline).encode(codec)
    read = decode(data)
    assert read.text == text
    assert read.newline == newline
    assert read.encode(read.text) == data


@pytest.mark.parametrize("name", ["utf_8", "UTF8", "utf-8-sig", "latin_1", "euc_kr", "gbk", "Shift_JIS", "cp949"])
def test_python_knows_an_encoding_by_several_names(name: str) -> None:
    assert decode(f"# -*- coding: {name} -*-\nA = 1\n".encode()).text.endswith("A = 1\n")


@pytest.mark.parametrize("name", ["rot13", "zip", "idna", "latin-99"])
def test_what_is_no_encoding_of_text_is_not_read(name: str) -> None:
    with pytest.raises(UnicodeError, match="is not known here"):
        decode(f"# coding: {name}\n".encode())


def test_ascii_holds_only_ascii() -> None:
    assert decode(b'<?xml version="1.0" encoding="US-ASCII"?><a/>').encoding.lower() == "us-ascii"
    with pytest.raises(UnicodeError):
        decode('<?xml version="1.0" encoding="US-ASCII"?><a>ü</a>'.encode())


@pytest.mark.parametrize("name", ["EUC-JP", "iso-8859-12", "windows-1259", "rot13", "unicode_escape", "x" * 90])
def test_other_encodings_are_refused_by_name(name: str) -> None:
    with pytest.raises(UnicodeError, match="save the file as UTF-8"):
        decode(f'<?xml version="1.0" encoding="{name}"?><a/>'.encode())


def test_utf_16_that_is_none_is_refused() -> None:
    with pytest.raises(UnicodeError, match="and the bytes are not"):
        decode(b'<?xml version="1.0" encoding="UTF-16"?><a/>')


@given(st.binary(max_size=80))
def test_any_bytes_are_text_or_a_unicode_error(data: bytes) -> None:
    try:
        read = decode(data)
    except UnicodeError:
        return
    assert read.encode(read.text) == data
