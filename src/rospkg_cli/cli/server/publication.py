"""The diagnostics that an editor has been sent."""

from __future__ import annotations

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
    """Sends diagnostics, those of a file only where they are not the last ones that were sent."""

    server: LanguageServer
    sent: dict[Path, SentDiagnostics] = field(default_factory=dict)

    def send(self, folder: Path, found: Mapping[Path, list[types.Diagnostic]], uris: Mapping[Path, str]) -> None:
        """Make what was found in a workspace what the editor shows of it; `uris` are those of the open files."""
        before = {path for path, sent in self.sent.items() if sent.folder == folder}
        for path in sorted(found.keys() | before):
            now = SentDiagnostics(folder, uris.get(path) or path.as_uri(), found.get(path, []))
            if now != self.sent.get(path):
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
        self.server.text_document_publish_diagnostics(types.PublishDiagnosticsParams(now.uri, now.diagnostics))
