"""The type of the fixture that writes a tree of texts."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path

Write = Callable[[Path, Mapping[str, str]], Path]
