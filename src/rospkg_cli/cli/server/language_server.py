"""The server: what an editor tells and asks, and the run that goes on beside it."""

from __future__ import annotations

import asyncio
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from lsprotocol import types
from pygls.lsp.server import LanguageServer
from pygls.uris import to_fs_path

from ... import __version__
from ...engine.discovery.discover import enclosing_package
from ...engine.discovery.locate import workspace_of
from ...report.told_once import told_once
from ...user_error import UserError
from .actions import FIX_ALL, actions, all_fixes
from .diagnostics import diagnostic
from .linted import Linted
from .live_workspace import LiveWorkspace

SETTLED = "rospkg.settled"
"""The command that is answered when there is nothing left to lint."""

PAUSE = 0.15
"""Seconds without a change after which packages are linted."""


class PackageServer(LanguageServer):
    """What is open in the editor, and what was found in it."""

    def __init__(self) -> None:
        super().__init__("rospkg", __version__)
        self.workspaces: dict[Path, LiveWorkspace] = {}
        self.linted: dict[Path, Linted] = {}
        """The last run over each workspace."""
        self.published: dict[Path, set[Path]] = {}
        """The files with diagnostics, by workspace."""
        self.worker = ThreadPoolExecutor(1, "lint")
        self.has_changed = asyncio.Event()
        self.is_settled = asyncio.Event()
        """Set while the diagnostics are those of the texts in the editor, in all packages."""
        self.loop: asyncio.Task[None] | None = None
        self.uris: dict[Path, str] = {}
        """The files that are open, as the editor writes their addresses."""
        self.told = ""
        """The last error that was shown."""

    def workspace_at(self, path: Path) -> LiveWorkspace | None:
        """Return the workspace of a file: the innermost folder of the editor around it, else that of its package."""
        around = [folder for folder in self.workspaces if path.is_relative_to(folder)]
        if around:
            return self.workspaces[max(around, key=lambda folder: len(folder.parts))]
        package = enclosing_package(path.parent)
        if package is None:
            return None
        folder = workspace_of([package]) or package
        return self.workspaces.setdefault(folder, LiveWorkspace(folder))

    def watch_files(self) -> None:
        """Ask an editor that can do so to say what changes on disk."""
        offered = self.client_capabilities.workspace
        watching = offered.did_change_watched_files if offered else None
        if watching and watching.dynamic_registration:
            wanted = types.DidChangeWatchedFilesRegistrationOptions([types.FileSystemWatcher("**/*")])
            each = types.Registration("files", types.WORKSPACE_DID_CHANGE_WATCHED_FILES, wanted)
            self.client_register_capability(types.RegistrationParams([each]))

    def put(self, uri: str, text: str | None) -> None:
        """Take what is in the editor, None for what is on disk; a run follows soon."""
        path = path_of(uri)
        if path is None or (live := self.workspace_at(path)) is None:
            return
        if text is None:
            self.uris.pop(path, None)
        else:
            self.uris[path] = uri
        live.put(path, None if text is None else text.encode("utf-8", "surrogatepass"))
        if text is not None and (package := enclosing_package(path.parent)):
            live.wanted.add(package)
        self.lint_soon()

    def lint_soon(self) -> None:
        self.is_settled.clear()
        self.has_changed.set()
        if self.loop is None or self.loop.done():
            self.loop = asyncio.get_running_loop().create_task(self.lint_on())

    async def lint_on(self) -> None:
        """Lint whenever something has changed and then rested; packages that are not judged yet come in between."""
        while True:
            await self.has_changed.wait()
            while self.has_changed.is_set():
                self.has_changed.clear()
                await asyncio.sleep(PAUSE)
            for folder, live in list(self.workspaces.items()):
                await self.lint(folder, live)
            if not all(live.is_finished for live in self.workspaces.values()):
                self.has_changed.set()
            elif not self.has_changed.is_set():
                self.is_settled.set()

    async def lint(self, folder: Path, live: LiveWorkspace) -> None:
        """Lint a workspace beside what goes on, and publish."""
        try:
            results = await asyncio.get_running_loop().run_in_executor(self.worker, live.lint)
        except UserError as error:
            live.is_finished = True
            if str(error) != self.told:
                self.told = str(error)
                self.window_show_message(types.ShowMessageParams(types.MessageType.Error, f"rospkg: {error}"))
            return
        except Exception as error:
            live.is_finished = True
            self.window_log_message(types.LogMessageParams(types.MessageType.Error, f"internal error: {error!r}"))
            return
        if live.session is not None:
            self.linted[folder] = Linted(live.session, live.root, told_once(results.findings))
            self.publish(folder)

    def publish(self, folder: Path) -> None:
        """Send the diagnostics of each file that has some or had some."""
        linted, codec = self.linted[folder], self.workspace.position_codec
        for path in sorted(linted.by_file.keys() | self.published.get(folder, set())):
            found = [diagnostic(each, linted.root, linted.source, codec) for each in linted.by_file.get(path, [])]
            self.text_document_publish_diagnostics(
                types.PublishDiagnosticsParams(self.uris.get(path) or path.as_uri(), found)
            )
        self.published[folder] = set(linted.by_file)

    def linted_at(self, path: Path) -> Linted | None:
        """Return the last run that saw a file as it is in the editor; None where there is none."""
        live = self.workspace_at(path)
        if live is None or path in live.changed:
            return None
        return self.linted.get(live.folder)


def path_of(uri: str) -> Path | None:
    """Return the path of a file on disk; None for what is none."""
    path = to_fs_path(uri) if uri.startswith("file:") else None
    return Path(path) if path else None


def watch_texts(server: PackageServer) -> None:
    """Let the server follow what is open, changed, saved and closed."""

    @server.feature(types.INITIALIZED)
    def initialized(_: types.InitializedParams) -> None:
        for folder in server.workspace.folders.values():
            if path := path_of(folder.uri):
                server.workspaces[path] = LiveWorkspace(path)
        server.watch_files()
        server.lint_soon()

    @server.feature(types.TEXT_DOCUMENT_DID_OPEN)
    def opened(asked: types.DidOpenTextDocumentParams) -> None:
        server.put(asked.text_document.uri, asked.text_document.text)

    @server.feature(types.TEXT_DOCUMENT_DID_CHANGE)
    def changed(asked: types.DidChangeTextDocumentParams) -> None:
        uri = asked.text_document.uri
        server.put(uri, server.workspace.get_text_document(uri).source)

    @server.feature(types.TEXT_DOCUMENT_DID_SAVE)
    def saved(asked: types.DidSaveTextDocumentParams) -> None:
        uri = asked.text_document.uri
        server.put(uri, server.workspace.get_text_document(uri).source)

    @server.feature(types.TEXT_DOCUMENT_DID_CLOSE)
    def closed(asked: types.DidCloseTextDocumentParams) -> None:
        server.put(asked.text_document.uri, None)

    @server.feature(types.WORKSPACE_DID_CHANGE_WATCHED_FILES)
    def on_disk(asked: types.DidChangeWatchedFilesParams) -> None:
        for each in asked.changes:
            path = path_of(each.uri)
            if path is not None and (live := server.workspace_at(path)) is not None:
                live.changed.add(path)
        server.lint_soon()

    @server.feature(types.WORKSPACE_DID_CHANGE_WORKSPACE_FOLDERS)
    def folders(asked: types.DidChangeWorkspaceFoldersParams) -> None:
        for each in asked.event.removed:
            if path := path_of(each.uri):
                server.workspaces.pop(path, None)
        for each in asked.event.added:
            if path := path_of(each.uri):
                server.workspaces[path] = LiveWorkspace(path)
        server.lint_soon()

    @server.command(SETTLED)
    async def settled(*_: object) -> None:
        """Answer when all diagnostics are up to date."""
        await server.is_settled.wait()


def offer_actions(server: PackageServer) -> None:
    """Let the server answer what can be done at a place."""
    kinds = [types.CodeActionKind.QuickFix, types.CodeActionKind(types.CodeActionKind.SourceFixAll)]

    @server.feature(
        types.TEXT_DOCUMENT_CODE_ACTION, types.CodeActionOptions(code_action_kinds=[*kinds], resolve_provider=True)
    )
    def at_place(asked: types.CodeActionParams) -> list[types.CodeAction]:
        path = path_of(asked.text_document.uri)
        linted = server.linted_at(path) if path else None
        return list(actions(linted, path, asked, server.workspace.position_codec)) if path and linted else []

    @server.feature(types.CODE_ACTION_RESOLVE)
    def resolved(action: types.CodeAction) -> types.CodeAction:
        data = action.data
        path = Path(data["path"]) if action.kind == FIX_ALL and isinstance(data, dict) else None
        if path and (linted := server.linted_at(path)):
            action.edit = all_fixes(linted, path, server.workspace.position_codec)
        return action
