"""What the server answers when an editor asks what can be done at a place."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from lsprotocol import types

from .actions import FIX_ALL, FIX_ALL_COMMAND, actions
from .answers import looked_up
from .fixing_all import FixingAll
from .language_server import PackageServer
from .linted import Linted
from .open_workspaces import path_of
from .refusal import UNANSWERED


def offer_actions(server: PackageServer) -> None:
    """Let the server offer actions, each for the texts as they are in the editor, once these are linted."""
    kinds = [types.CodeActionKind.QuickFix, types.CodeActionKind(types.CodeActionKind.SourceFixAll)]
    fixing = FixingAll(server)

    @server.feature(
        types.TEXT_DOCUMENT_CODE_ACTION, types.CodeActionOptions(code_action_kinds=[*kinds], resolve_provider=True)
    )
    async def at_place(asked: types.CodeActionParams) -> list[types.CodeAction]:
        path = path_of(asked.text_document.uri)
        return await server.in_time(actions_at(server, path, asked)) if path else []

    @server.feature(types.CODE_ACTION_RESOLVE)
    async def resolved(action: types.CodeAction) -> types.CodeAction:
        """Fill in the edit if that can be done in time; the command that the action also has makes it if not."""
        if action.kind == FIX_ALL and isinstance(action.data, dict):
            action.edit = await fixing.edit_in_time(str(action.data["key"]), Path(action.data["path"]))
        return action

    @server.feature(UNANSWERED)
    def unanswered(told: Any) -> None:
        fixing.withhold(str(told.key))

    @server.command(FIX_ALL_COMMAND)
    def fix_all(key: str, path: str) -> None:
        """Fix all in the package of a file, unless that was done by the edit of the action; answered at once."""
        fixing.apply_later(key, Path(path))


async def actions_at(server: PackageServer, path: Path, asked: types.CodeActionParams) -> list[types.CodeAction]:
    """Return what can be done at a range; what the run before found is not offered."""
    live = server.workspaces.at(path)
    if live is None:
        return []
    live.asked.add(path)
    linted = await server.linted_at(path)
    try:
        found = await looked_up(server, listed, linted, path, asked) if linted else []
    except Exception:
        server.crashed(live, path, "actions")
        found = []
    live.asked.discard(path)
    return found


def listed(linted: Linted, path: Path, asked: types.CodeActionParams) -> list[types.CodeAction]:
    return list(actions(linted, path, asked))
