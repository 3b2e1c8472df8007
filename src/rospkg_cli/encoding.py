"""Decode bytes and encode text, so that an edited file keeps its encoding, byte order mark and line ends."""

from __future__ import annotations

import codecs
import re
from typing import Literal

from .lazy_regex import regex
from .light_dataclasses import dataclass

Newline = Literal["\n", "\r\n", ""]

BOMS = (
    (codecs.BOM_UTF8, "utf-8"),
    (codecs.BOM_UTF16_LE, "utf-16-le"),
    (codecs.BOM_UTF16_BE, "utf-16-be"),
)

DECLARED = regex(rb"""\A\s*<\?xml[^>]*?encoding\s*=\s*["']([A-Za-z0-9._-]+)["']""")
CODING = regex(rb"\A(?:[^\n]*\n)?[ \t\f]*#.*?coding[:=][ \t]*([-\w.]+)")

KNOWN = regex(r"utf-?(8|16(-?[bl]e)?)|us-ascii|ascii|iso-?8859-?\d+|latin-?1|windows-125\d|cp125\d", re.IGNORECASE)
"""The encodings that are read; anything else is one clear finding."""
IN_PYTHON = regex(
    KNOWN.pattern + r"|utf-?8-?sig|latin-?\d+|cp-?\d+|gbk|gb-?(2312|18030)|big5|euc-?(kr|jp)|s(hift)?-?jis|koi8-?[ru]",
    re.IGNORECASE,
)
"""Those of Python's sources, with `-` for `_`, which Python takes for the same."""


@dataclass(frozen=True)
class DecodedText:
    """A decoded text whose line ends are `\\n`; where ends are mixed (`newline` is ""), as they stand."""

    text: str
    encoding: str = "utf-8"
    bom: bytes = b""
    newline: Newline = "\n"

    def encode(self, text: str) -> bytes:
        """Return the bytes of an edited text; raises UnicodeEncodeError where the encoding can't hold it."""
        if self.newline == "\r\n":
            text = text.replace("\n", "\r\n")
        return self.bom + text.encode(self.encoding)


def decode(data: bytes) -> DecodedText:
    """Decode bytes by their byte order mark, else by the encoding of an XML or Python header, else as UTF-8.

    Raises UnicodeError where that fails.
    """
    bom, encoding = b"", ""
    if data.startswith((codecs.BOM_UTF32_LE, codecs.BOM_UTF32_BE)):
        raise UnicodeError("the file is in UTF-32, which no tool of ROS reads; save it as UTF-8")
    for mark, name in BOMS:
        if data.startswith(mark):
            bom, encoding = mark, name
            break
    body = data[len(bom) :]
    if not encoding:
        encoding = detect_utf16(body) or declared_encoding(body)
    text = body.decode(encoding)
    if "\r" not in text:
        return DecodedText(text, encoding, bom, "\n")
    if text.count("\r") == text.count("\n") == text.count("\r\n"):
        return DecodedText(text.replace("\r\n", "\n"), encoding, bom, "\r\n")
    return DecodedText(text, encoding, bom, "")


def detect_utf16(body: bytes) -> str:
    """Return the encoding of XML in UTF-16 without a mark: recognized by a `<` of two bytes; else ""."""
    return {b"<\0": "utf-16-le", b"\0<": "utf-16-be"}.get(body[:2], "")


def declared_encoding(body: bytes) -> str:
    """Return the encoding that a header names; raises UnicodeError for an unknown or a wrong one."""
    in_xml = DECLARED.match(body)
    found = in_xml or CODING.match(body)
    if found is None:
        return "utf-8"
    name = found.group(1).decode("ascii", "replace")
    is_known = KNOWN.fullmatch(name) if in_xml else IN_PYTHON.fullmatch(name.replace("_", "-"))
    try:
        known = codecs.lookup(name).name if is_known else ""
    except LookupError:
        known = ""
    if not known:
        raise UnicodeError(f"the encoding {name!r} is not known here; save the file as UTF-8")
    if known.startswith("utf-16"):
        raise UnicodeError(f"the encoding is said to be {name!r}, and the bytes are not; save the file as UTF-8")
    return name
