"""An editor as far as a language server sees one: pygls' own client, in an event loop that tests drive step by step."""

from __future__ import annotations

import asyncio
import sys
import time
from collections.abc import Callable, Coroutine, Mapping, Sequence
from pathlib import Path
from typing import Any, TypeVar
from urllib.parse import unquote

from lsprotocol import types
from pygls.lsp.client import LanguageClient
from pygls.protocol import default_converter

PATIENCE = 60
"""Seconds after which what does not come is missed."""

T = TypeVar("T")


class Editor:
    """A client with one folder open; `diagnostics` has the last ones of each file, by path."""

    program: tuple[str, ...] = ("-m", "rospkg_cli", "server")
    """What Python is called with."""
    options: Mapping[str, object] = {"answerWithin": PATIENCE}
    """What the server is told at the start."""

    def __init__(self, folder: Path, **environment: str) -> None:
        self.loop, self.folder = asyncio.new_event_loop(), folder
        self.client = LanguageClient("editor", "1", converter_factory=converter)
        self.diagnostics: dict[Path, tuple[types.Diagnostic, ...]] = {}
        self.messages: list[str] = []
        self.watched: list[types.Registration] = []
        """What the server wants to be told of."""
        self.versions: dict[Path, int] = {}
        self.texts: dict[Path, str] = {}
        self.client.feature(types.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS)(lambda found: self.published(found))
        self.client.feature(types.WINDOW_SHOW_MESSAGE)(lambda found: self.shown(found))
        self.client.feature(types.WINDOW_LOG_MESSAGE)(lambda found: self.shown(found))
        self.client.feature(types.CLIENT_REGISTER_CAPABILITY)(lambda asked: self.watched.extend(asked.registrations))
        self.run(self.start(folder, environment))

    async def start(self, folder: Path, environment: dict[str, str]) -> None:
        await self.client.start_io(sys.executable, *self.program, env=environment)
        folders = [types.WorkspaceFolder(folder.as_uri(), folder.name)]
        watching = types.DidChangeWatchedFilesClientCapabilities(dynamic_registration=True)
        able = types.ClientCapabilities(types.WorkspaceClientCapabilities(did_change_watched_files=watching))
        asked = types.InitializeParams(
            able, initialization_options=dict(self.options), root_uri=folder.as_uri(), workspace_folders=folders
        )
        self.capabilities = (await self.client.initialize_async(asked)).capabilities
        self.client.initialized(types.InitializedParams())

    def published(self, found: types.PublishDiagnosticsParams) -> None:
        self.diagnostics[Path(unquote(found.uri.removeprefix("file://")))] = tuple(found.diagnostics)

    def shown(self, found: types.ShowMessageParams | types.LogMessageParams) -> None:
        self.messages.append(found.message)

    @property
    def process_id(self) -> int:
        return int(getattr(self.client, "_server").pid)  # noqa: B009

    def run(self, coroutine: Coroutine[Any, Any, T]) -> T:
        return self.loop.run_until_complete(asyncio.wait_for(coroutine, PATIENCE))

    def until(self, holds: Callable[[], bool]) -> None:
        """Wait until something holds; fails where it never does."""
        end = time.monotonic() + PATIENCE
        while not holds():
            assert time.monotonic() < end, f"it did not come: {self.diagnostics} {self.messages}"
            self.run(asyncio.sleep(0.02))

    def settle(self) -> None:
        """Wait until the server has linted all that was typed."""
        asked = types.ExecuteCommandParams("rospkg.settled", [])
        self.loop.run_until_complete(asyncio.wait_for(self.client.workspace_execute_command_async(asked), 600))

    def codes(self, path: Path) -> list[Any]:
        return sorted(str(each.code) for each in self.diagnostics.get(path, ()))

    def open(self, path: Path) -> None:
        self.versions[path], self.texts[path] = 1, path.read_text()
        document = types.TextDocumentItem(path.as_uri(), "text", 1, self.texts[path])
        self.client.text_document_did_open(types.DidOpenTextDocumentParams(document))

    def type(self, path: Path, text: str) -> None:
        """Make the text of an open file another, without saving it."""
        self.versions[path] += 1
        self.texts[path] = text
        document = types.VersionedTextDocumentIdentifier(self.versions[path], path.as_uri())
        change = types.TextDocumentContentChangeWholeDocument(text)
        self.client.text_document_did_change(types.DidChangeTextDocumentParams(document, [change]))

    def save(self, path: Path) -> None:
        """Write the text of an open file to the disk, and say so."""
        path.write_text(self.texts[path])
        saved = types.DidSaveTextDocumentParams(types.TextDocumentIdentifier(path.as_uri()))
        self.client.text_document_did_save(saved)

    def close(self, path: Path) -> None:
        self.client.text_document_did_close(
            types.DidCloseTextDocumentParams(types.TextDocumentIdentifier(path.as_uri()))
        )

    def wrote(self, *paths: Path) -> None:
        """Say that files were written on disk, or made, or removed."""
        changes = [types.FileEvent(path.as_uri(), types.FileChangeType.Changed) for path in paths]
        self.client.workspace_did_change_watched_files(types.DidChangeWatchedFilesParams(changes))

    def change_folders(self, *, added: Sequence[Path] = (), removed: Sequence[Path] = ()) -> None:
        new, gone = ([types.WorkspaceFolder(each.as_uri(), each.name) for each in some] for some in (added, removed))
        event = types.WorkspaceFoldersChangeEvent(new, gone)
        self.client.workspace_did_change_workspace_folders(types.DidChangeWorkspaceFoldersParams(event))

    def place(self, path: Path, at: str) -> dict[str, Any]:
        """Return what asks for a place of an open file: that of the `|` in a part of its text."""
        before, _, after = at.partition("|")
        start = self.texts[path].index(before + after) + len(before)
        lines = self.texts[path][:start].split("\n")
        position = types.Position(len(lines) - 1, len(lines[-1].encode("utf-16-le")) // 2)
        return {"text_document": types.TextDocumentIdentifier(path.as_uri()), "position": position}

    def hover(self, path: Path, at: str) -> str:
        """Return what is told of a place; "" where nothing is."""
        found = self.run(self.client.text_document_hover_async(types.HoverParams(**self.place(path, at))))
        return str(getattr(found.contents, "value", "")) if found else ""

    def definition(self, path: Path, at: str) -> list[str]:
        """Return what defines what stands at a place: addresses, lines from 1, and columns from 0."""
        asked = types.DefinitionParams(**self.place(path, at))
        found: Any = self.run(self.client.text_document_definition_async(asked))
        return [f"{unquote(each.uri)}:{each.range.start.line + 1}:{each.range.start.character}" for each in found or ()]

    def completion(self, path: Path, at: str) -> list[str]:
        asked = types.CompletionParams(**self.place(path, at))
        found: Any = self.run(self.client.text_document_completion_async(asked))
        return [each.label for each in found.items] if found else []

    def actions(self, path: Path, line: int = 0, last: int = 10_000) -> list[types.CodeAction]:
        at = types.Range(types.Position(line, 0), types.Position(last, 0))
        asked = types.CodeActionParams(types.TextDocumentIdentifier(path.as_uri()), at, types.CodeActionContext([]))
        found = self.run(self.client.text_document_code_action_async(asked))
        return [each for each in found or () if isinstance(each, types.CodeAction)]

    def quit(self) -> None:
        self.run(self.client.shutdown_async(None))
        self.client.exit(None)
        self.run(self.client.stop())
        self.loop.close()


def converter() -> Any:
    """Return pygls' converter, which takes an action that has a command for the command (lsprotocol 2025.0)."""
    found = default_converter()

    def action(given: Any, _: Any) -> types.Command | types.CodeAction:
        kind = types.Command if isinstance(given.get("command"), str) else types.CodeAction
        return found.structure(given, kind)

    found.register_structure_hook(types.Command | types.CodeAction, action)
    return found


def applied(text: str, edits: Any) -> str:
    """Return a text with the edits of an editor made, whose positions count code points of the plane of ASCII."""
    lines = text.split("\n")
    starts = [sum(len(line) + 1 for line in lines[:number]) for number in range(len(lines) + 1)]
    for edit in sorted(edits, key=lambda each: (each.range.start.line, each.range.start.character), reverse=True):
        first, last = edit.range.start, edit.range.end
        start, end = starts[first.line] + first.character, starts[last.line] + last.character
        text = text[:start] + edit.new_text + text[end:]
    return text
