"""A file as an editor has it."""

from __future__ import annotations

from ...light_dataclasses import dataclass


@dataclass(frozen=True)
class OpenText:
    """The text of an open file, as it would be saved."""

    uri: str
    """As the editor writes it: another spelling of the same address is another file to it."""
    version: int | None
    data: bytes
