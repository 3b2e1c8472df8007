"""Messages of the packages that every ROS 2 distribution has: enough to see that a name was meant otherwise.

Later distributions may add to a package; so nothing may be concluded from a name that is not here and like none.
"""

from __future__ import annotations

from collections.abc import Mapping

from .read_table import rows, sets

CORE_MESSAGES: Mapping[str, frozenset[str]] = sets("core_messages.txt", "messages")

CORE_DEPENDENCIES: Mapping[str, tuple[str, ...]] = rows("core_messages.txt", "dependencies")
"""The packages whose interfaces each of them links, and so passes on."""
