"""Which requests of an editor are still to be answered, and until when; several threads ask it."""

from __future__ import annotations

import time
from threading import Condition
from typing import Any

from ...light_dataclasses import dataclass, field
from .refusal import REFUSED, limit_in

MARGIN = 0.03
"""Seconds that the server has more than it gives itself, to say so."""

Message = dict[str, Any]


@dataclass
class Deadlines:
    """Each request is answered once: by the server, or by a refusal where that took too long."""

    limit: float = limit_in(None)
    waiting: dict[object, tuple[float, Message]] = field(default_factory=dict)
    """The requests in their order, with the time of each deadline, by their ids."""
    refused: set[object] = field(default_factory=set)
    """The ids of those that the server has not answered yet, and need not."""
    change: Condition = field(default_factory=Condition)

    def asked(self, message: Message) -> None:
        """Take what an editor says; `initialize` has the limit."""
        if message.get("method") == "initialize":
            self.limit = limit_in((message.get("params") or {}).get("initializationOptions"))
        if message.get("method") in REFUSED and "id" in message:
            with self.change:
                self.waiting[message["id"]] = (time.monotonic() + self.limit + MARGIN, message)
                self.change.notify()

    def lets_through(self, message: Message) -> bool:
        """Return whether the editor still waits for what the server says."""
        if "method" in message or "id" not in message:
            return True
        with self.change:
            self.waiting.pop(message["id"], None)
            is_late = message["id"] in self.refused
            self.refused.discard(message["id"])
        return not is_late

    def late(self) -> Message:
        """Wait for the next request whose answer takes too long, and return it."""
        with self.change:
            while True:
                number, (end, message) = next(iter(self.waiting.items()), (None, (float("inf"), {})))
                left = end - time.monotonic()
                if left <= 0:
                    del self.waiting[number]
                    self.refused.add(number)
                    return message
                self.change.wait(left if self.waiting else None)
