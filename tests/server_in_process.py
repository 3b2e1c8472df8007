"""A language server in this process, spoken to in its own event loop, so that tests can hold up what it does."""

from __future__ import annotations

import asyncio
import json
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from editor import PATIENCE

from rospkg_cli.cli.server.features import server_with_features

Message = dict[str, Any]


class ServerInProcess:
    """A server with one folder open; `sent` has all that it said. To be made in a running event loop."""

    def __init__(self, folder: Path) -> None:
        self.server, self.folder = server_with_features(), folder
        self.sent: list[Message] = []
        self.versions: dict[Path, int] = {}
        self.server.protocol.set_writer(self, include_headers=False)
        folders = [{"uri": folder.as_uri(), "name": folder.name}]
        options = {"answerWithin": PATIENCE}
        given = {"processId": None, "rootUri": folder.as_uri(), "capabilities": {}, "initializationOptions": options}
        self.ask("initialize", {**given, "workspaceFolders": folders})
        self.tell("initialized", {})

    def write(self, data: bytes) -> None:
        """Take what the server sends."""
        self.sent.append(json.loads(data))

    def close(self) -> None:
        """Do nothing: nobody listens."""

    def handle(self, message: Message) -> None:
        protocol = self.server.protocol
        protocol.handle_message(protocol.structure_message({"jsonrpc": "2.0", **message}))

    def tell(self, method: str, params: Message) -> None:
        self.handle({"method": method, "params": params})

    def ask(self, method: str, params: Message) -> int:
        """Ask for something, and return the number of the request."""
        number = 1_000_000 + len(self.sent) + sum(self.versions.values())
        while any(each.get("id") == number for each in self.sent):
            number += 1
        self.handle({"id": number, "method": method, "params": params})
        return number

    async def answer(self, method: str, params: Message) -> Message:
        """Return what is answered: with `result`, or with `error`."""
        number = self.ask(method, params)
        await until(lambda: any(each.get("id") == number for each in self.sent))
        return next(each for each in self.sent if each.get("id") == number)

    async def settle(self) -> None:
        await self.answer("workspace/executeCommand", {"command": "rospkg.settled", "arguments": []})

    def open(self, path: Path, text: str) -> None:
        self.versions[path] = 1
        document = {"uri": path.as_uri(), "languageId": "xml", "version": 1, "text": text}
        self.tell("textDocument/didOpen", {"textDocument": document})

    def type(self, path: Path, text: str) -> None:
        self.versions[path] += 1
        document = {"uri": path.as_uri(), "version": self.versions[path]}
        self.tell("textDocument/didChange", {"textDocument": document, "contentChanges": [{"text": text}]})

    def published(self, path: Path) -> list[list[str]]:
        """Return the codes of each diagnostics of a file that were sent, in their order."""
        return [
            [each["code"] for each in message["params"]["diagnostics"]]
            for message in self.sent
            if message.get("method") == "textDocument/publishDiagnostics" and message["params"]["uri"] == path.as_uri()
        ]

    async def actions(self, path: Path) -> Message:
        whole = {"start": {"line": 0, "character": 0}, "end": {"line": 999, "character": 0}}
        asked = {"textDocument": {"uri": path.as_uri()}, "range": whole, "context": {"diagnostics": []}}
        return await self.answer("textDocument/codeAction", asked)


async def until(holds: Callable[[], bool]) -> None:
    """Wait until something holds; fails where it never does."""
    end = time.monotonic() + PATIENCE
    while not holds():
        assert time.monotonic() < end, "it did not come"
        await asyncio.sleep(0.005)
