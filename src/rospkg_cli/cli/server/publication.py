"""The diagnostics that an editor has been sent."""

from __future__ import annotations

import asyncio
from collections.abc import Mapping, Set
from pathlib import Path

from lsprotocol import types
from pygls.lsp.server import LanguageServer

from ...light_dataclasses import dataclass, field


@dataclass(frozen=True)
class SentDiagnostics:
    """What an editor shows of a file."""

    folder: Path
    """Of the workspace that found it."""
    uri: str
    diagnostics: list[types.Diagnostic]


@dataclass
class Publication:
    """Sends diagnostics, those of a file only where they are not the last ones that were sent.

    One file at a time, and what is asked meanwhile is heard between two: thousands of findings take their time.
    """

    server: LanguageServer
    sent: dict[Path, SentDiagnostics] = field(default_factory=dict)
    waiting: dict[str, SentDiagnostics] = field(default_factory=dict)
    """What is still to be sent, by its address; what comes later of a file replaces what did not leave yet."""
    all_left: asyncio.Event = field(default_factory=asyncio.Event)
    """Set while nothing is waiting."""

    def __post_init__(self) -> None:
        self.all_left.set()

    def send(
        self,
        folder: Path,
        found: Mapping[Path, list[types.Diagnostic]],
        uris: Mapping[Path, str],
        again: Set[Path] = frozenset(),
    ) -> None:
        """Make what was found in a workspace what the editor shows of it; `uris` are those of the open files.

        Those of the files of `again` are sent even if they are the last ones: an editor then asks for actions again.
        """
        before = {path for path, sent in self.sent.items() if sent.folder == folder}
        for path in sorted(found.keys() | before):
            now = SentDiagnostics(folder, uris.get(path) or path.as_uri(), found.get(path, []))
            if path in again or now != self.sent.get(path):
                self.publish(now)
            self.sent[path] = now
            if path not in found:
                del self.sent[path]

    def forget(self, folders: Set[Path]) -> None:
        """Take away what was shown of all folders but these."""
        for path, sent in list(self.sent.items()):
            if sent.folder not in folders:
                self.publish(SentDiagnostics(sent.folder, sent.uri, []))
                del self.sent[path]

    def publish(self, now: SentDiagnostics) -> None:
        """Let something be sent after what is waiting."""
        self.waiting.pop(now.uri, None)
        self.waiting[now.uri] = now
        if self.all_left.is_set():
            self.all_left.clear()
            asyncio.get_running_loop().call_soon(self.send_next)

    def send_next(self) -> None:
        now = self.waiting.pop(next(iter(self.waiting)))
        if self.waiting:
            asyncio.get_running_loop().call_soon(self.send_next)
        else:
            self.all_left.set()
        self.server.text_document_publish_diagnostics(types.PublishDiagnosticsParams(now.uri, now.diagnostics))
