"""What the server answers when an editor asks what can be done at a place."""

from __future__ import annotations

import asyncio
from collections.abc import Mapping, Set
from pathlib import Path
from typing import Any

from lsprotocol import types

from .actions import FIX_ALL, FIX_ALL_COMMAND, actions
from .answers import looked_up
from .carried import carried
from .fixing_all import FixingAll
from .language_server import PackageServer
from .linted import Linted
from .live_workspace import LiveWorkspace
from .open_text import OpenText
from .open_workspaces import path_of
from .refusal import UNANSWERED

LISTING = 0.1
"""Seconds that are left for making actions when a run has been waited for."""


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
    def unanswered(answer: Any) -> None:
        fixing.withhold(str(answer.key))

    @server.command(FIX_ALL_COMMAND)
    def fix_all(key: str, path: str) -> None:
        """Fix all in the package of a file, unless that was done by the edit of the action; answered at once."""
        fixing.apply_later(key, Path(path))


async def actions_at(server: PackageServer, path: Path, asked: types.CodeActionParams) -> list[types.CodeAction]:
    """Return what can be done at a range, by the run over the texts as they are where that ends in time.

    Where it does not, by what the run before found and still holds; the diagnostics of the file are then sent again
    when the run has ended, at which editors ask again.
    """
    live = server.workspaces.at(path)
    if live is None:
        return []
    live.asked.add(path)
    linted = await soon_linted(server, live, path)
    texts, changed = (None, frozenset()) if live.is_current else (dict(live.texts), live.changed | live.running)
    try:
        found = await looked_up(server, listed, linted, texts, changed, path, asked) if linted else []
    except Exception:
        server.crashed(live, path, "actions")
        found = []
    if live.is_current:
        live.asked.discard(path)
    return found


async def soon_linted(server: PackageServer, live: LiveWorkspace, path: Path) -> Linted | None:
    """Return the run over the texts as they are, or the one before where that takes too long."""
    run = asyncio.ensure_future(server.linted_at(path))
    await asyncio.wait([run], timeout=max(0.0, server.limit - LISTING))
    if not run.done() and live.linted is not None:
        run.cancel()
        return live.linted
    return await run


def listed(
    linted: Linted, texts: Mapping[Path, OpenText] | None, changed: Set[Path], path: Path, asked: types.CodeActionParams
) -> list[types.CodeAction]:
    """Return what can be done by a run; by what is left of it in other texts, where some are given."""
    return list(actions(linted if texts is None else carried(linted, texts, changed, path), path, asked))
