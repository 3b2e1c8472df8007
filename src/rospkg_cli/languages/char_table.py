"""Convert offsets in UTF-8 bytes, in which parsers count, to offsets in characters."""

from __future__ import annotations

from array import array


def char_table(text: str) -> array[int]:
    """Return, for each byte of the UTF-8 text and its end, the index of the character it belongs to."""
    table = array("I")
    for index, char in enumerate(text):
        table.extend([index] * len(char.encode("utf-8", "surrogatepass")))
    table.append(len(text))
    return table
