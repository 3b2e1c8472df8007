"""Messages of the packages that every ROS 2 distribution has: enough to recognise a misspelt name.

Later distributions may add to a package; so a name that is not here, and similar to none, may exist.
"""

from __future__ import annotations

from collections.abc import Mapping

from .read_table import rows, sets

CORE_MESSAGES: Mapping[str, frozenset[str]] = sets("core_messages.txt", "messages")

CORE_DEPENDENCIES: Mapping[str, tuple[str, ...]] = rows("core_messages.txt", "dependencies")
"""The packages whose interfaces each of them links, and so passes on."""
