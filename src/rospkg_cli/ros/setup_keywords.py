"""The keyword arguments of setup() that setuptools knows, and those that well-known plugins of it add."""

from __future__ import annotations

from collections.abc import Mapping

from .read_table import rows, words

BUILDS: Mapping[str, str] = {name: " ".join(rest) for name, rest in rows("setup_keywords.txt", "builds").items()}
"""Those that say what is built or installed, each with what happens where it is misspelt."""

KEYWORDS = frozenset(BUILDS) | words("setup_keywords.txt", "describes")
"""All that setuptools itself knows."""

OF_PLUGINS = words("setup_keywords.txt", "others")
