"""PRM003: blocks for costmaps of nav2 that no costmap reads, in files with the block of the server that makes it."""

from __future__ import annotations

from collections.abc import Iterator

from ..fault import Fault
from .block_readers import BlockReaders
from .costmap_blocks import costmap_defaults, costmap_message, unread_costmaps
from .unchanged_values import ONLY_DEFAULTS, holds_defaults


def costmap_faults(readers: BlockReaders) -> Iterator[tuple[str, Fault]]:
    """Yield path and fault: an info where the block holds no more than defaults, or no server is started."""
    for file, block, server in unread_costmaps(readers.launched):
        same = ONLY_DEFAULTS if holds_defaults(block, costmap_defaults) else ""
        is_mild = bool(same) or readers.is_idle(file.path, server.key.span)
        yield file.path, Fault(block.key.span, costmap_message(block, server, same), "info" if is_mild else None)
