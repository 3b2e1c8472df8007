"""Which function reads which model: the one table that the engine and joined slices go by."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

from .files import Reading
from .manifest import Manifest, read_manifest
from .unreadable import Unreadable

READERS: dict[type, Callable[[Reading], Iterable[Any | Unreadable]]] = {
    Manifest: read_manifest,
}
"""A reader yields models and Unreadables; it may raise UnreadableError where it reads a single file."""
