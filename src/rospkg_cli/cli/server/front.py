"""What stands between an editor and the server, in a process of its own, and is never busy.

A thread that reads a large file, or collects garbage, holds up all others of its process, that which would refuse what
an editor asks meanwhile, too. So another process passes the messages on, and refuses in time what is not answered.
"""

from __future__ import annotations

import json
from contextlib import suppress
from queue import SimpleQueue
from threading import Lock, Thread
from typing import Any, BinaryIO

from ...light_dataclasses import dataclass, field
from .deadlines import Deadlines
from .framing import bodies, framed
from .refusal import refusal, unanswered


@dataclass
class Streams:
    """Where messages of somebody come from, and where those for it go."""

    heard: BinaryIO
    sink: BinaryIO


@dataclass
class Front:
    """Passes messages on between an editor and a server."""

    editor: Streams
    server: Streams
    deadlines: Deadlines = field(default_factory=Deadlines)
    queue: SimpleQueue[bytes | None] = field(default_factory=SimpleQueue)
    """Messages for the server, which may be too busy to read them now."""
    telling: Lock = field(default_factory=Lock)

    def run(self) -> None:
        """Go on until the server has said its last."""
        for work in (self.hear_editor, self.tell_server, self.refuse):
            Thread(target=work, daemon=True).start()
        for body in bodies(self.server.heard):
            if self.deadlines.lets_through(parsed(body)):
                self.tell_editor(body)

    def hear_editor(self) -> None:
        for body in bodies(self.editor.heard):
            self.deadlines.asked(parsed(body))
            self.queue.put(body)
        self.queue.put(None)

    def tell_server(self) -> None:
        with suppress(OSError), self.server.sink:
            while (body := self.queue.get()) is not None:
                self.server.sink.write(framed(body))
                self.server.sink.flush()

    def refuse(self) -> None:
        while True:
            asked = self.deadlines.late()
            if answer := unanswered(asked):
                self.queue.put(answer)
            self.tell_editor(refusal(asked))

    def tell_editor(self, body: bytes) -> None:
        """Say something to the editor; where it has gone, the server hears so by itself."""
        with suppress(OSError), self.telling:
            self.editor.sink.write(framed(body))
            self.editor.sink.flush()


def parsed(body: bytes) -> dict[str, Any]:
    """Return a message; an empty one for what is none, about which the server complains."""
    with suppress(ValueError, RecursionError):
        found = json.loads(body)
        return found if isinstance(found, dict) else {}
    return {}
