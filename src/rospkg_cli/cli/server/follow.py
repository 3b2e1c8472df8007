"""What an editor reports: which folders and files are open, what is typed, what changes on disk."""

from __future__ import annotations

from lsprotocol import types

from .language_server import PackageServer
from .open_text import OpenText
from .open_workspaces import path_of
from .refusal import limit_in

SETTLED = "rospkg.settled"
"""The command that is answered when there is nothing left to lint."""


def follow_texts(server: PackageServer) -> None:
    """Let the server follow what is open, changed, saved and closed."""

    def put(uri: str) -> None:
        if path := path_of(uri):
            document = server.workspace.get_text_document(uri)
            data = document.source.encode("utf-8", "surrogatepass")
            server.workspaces.put(path, OpenText(uri, document.version, data))
            server.lints.soon()

    @server.feature(types.TEXT_DOCUMENT_DID_OPEN)
    def opened(asked: types.DidOpenTextDocumentParams) -> None:
        put(asked.text_document.uri)

    @server.feature(types.TEXT_DOCUMENT_DID_CHANGE)
    def changed(asked: types.DidChangeTextDocumentParams) -> None:
        put(asked.text_document.uri)

    @server.feature(types.TEXT_DOCUMENT_DID_SAVE)
    def saved(asked: types.DidSaveTextDocumentParams) -> None:
        put(asked.text_document.uri)

    @server.feature(types.TEXT_DOCUMENT_DID_CLOSE)
    def closed(asked: types.DidCloseTextDocumentParams) -> None:
        if path := path_of(asked.text_document.uri):
            server.workspaces.put(path, None)
            server.lints.soon()


def follow_folders(server: PackageServer) -> None:
    """Let the server follow which folders are open."""

    @server.feature(types.INITIALIZE)
    def initialize(asked: types.InitializeParams) -> None:
        server.limit = limit_in(asked.initialization_options)

    @server.feature(types.SHUTDOWN)
    def shut_down(*_: object) -> None:
        for live in server.workspaces:
            live.look.end()

    @server.feature(types.INITIALIZED)
    def initialized(_: types.InitializedParams) -> None:
        for folder in server.workspace.folders.values():
            if path := path_of(folder.uri):
                server.workspaces.open(path)
        watch_files(server)
        server.lints.soon()

    @server.feature(types.WORKSPACE_DID_CHANGE_WORKSPACE_FOLDERS)
    def folders(asked: types.DidChangeWorkspaceFoldersParams) -> None:
        for each in asked.event.removed:
            if path := path_of(each.uri):
                server.workspaces.close(path)
        for each in asked.event.added:
            if path := path_of(each.uri):
                server.workspaces.open(path)
        server.lints.soon()

    @server.command(SETTLED)
    async def settled(*_: object) -> None:
        """Answer when all diagnostics are up to date."""
        await server.lints.is_settled.wait()
        await server.shown.all_left.wait()


def follow_disk(server: PackageServer) -> None:
    """Let the server follow what changes on disk."""

    @server.feature(types.WORKSPACE_DID_CHANGE_WATCHED_FILES)
    def on_disk(asked: types.DidChangeWatchedFilesParams) -> None:
        for each in asked.changes:
            if path := path_of(each.uri):
                server.workspaces.touch(path)
        server.lints.soon()


def watch_files(server: PackageServer) -> None:
    """Ask an editor that can do so to say what changes on disk."""
    offered = server.client_capabilities.workspace
    watching = offered.did_change_watched_files if offered else None
    if watching and watching.dynamic_registration:
        wanted = types.DidChangeWatchedFilesRegistrationOptions([types.FileSystemWatcher("**/*")])
        each = types.Registration("files", types.WORKSPACE_DID_CHANGE_WATCHED_FILES, wanted)
        server.client_register_capability(types.RegistrationParams([each]))
        server.reports_changes = True
