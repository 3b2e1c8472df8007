"""Offsets in bytes become offsets in characters."""

from __future__ import annotations

import pytest

from rospkg_cli.languages.char_table import CharTable


@pytest.mark.parametrize("text", ["", "abc", "é", "aé", "éa", "aébc€d", "😀😀x\ud800é", "über größe"])
def test_each_byte_has_its_character(text: str) -> None:
    expected = [index for index, char in enumerate(text) for _ in char.encode("utf-8", "surrogatepass")]
    table = CharTable(text)
    assert [table[byte] for byte in range(len(expected) + 3)] == [*expected, *[len(text)] * 3]
