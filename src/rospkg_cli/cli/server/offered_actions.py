"""What the server answers when an editor asks what can be done at a place."""

from __future__ import annotations

import asyncio
from pathlib import Path

from lsprotocol import types

from .actions import FIX_ALL, actions, all_fixes
from .language_server import PackageServer
from .open_workspaces import path_of


def offer_actions(server: PackageServer) -> None:
    """Let the server offer actions, each for the texts as they are in the editor, once these are linted."""
    kinds = [types.CodeActionKind.QuickFix, types.CodeActionKind(types.CodeActionKind.SourceFixAll)]

    @server.feature(
        types.TEXT_DOCUMENT_CODE_ACTION, types.CodeActionOptions(code_action_kinds=[*kinds], resolve_provider=True)
    )
    async def at_place(asked: types.CodeActionParams) -> list[types.CodeAction]:
        path = path_of(asked.text_document.uri)
        linted = await server.linted_at(path) if path else None
        return list(actions(linted, path, asked)) if path and linted else []

    @server.feature(types.CODE_ACTION_RESOLVE)
    async def resolved(action: types.CodeAction) -> types.CodeAction:
        data = action.data
        path = Path(data["path"]) if action.kind == FIX_ALL and isinstance(data, dict) else None
        if path and (linted := await server.linted_at(path)):
            loop = asyncio.get_running_loop()
            action.edit = await loop.run_in_executor(server.linting, all_fixes, linted, path)
        return action
