"""All safe fixes of a package as an editor asks for them: they take more rounds than a request may wait for."""

from __future__ import annotations

import asyncio
from collections import deque
from pathlib import Path

from lsprotocol import types
from pygls.exceptions import JsonRpcContentModified

from ...engine.live.safe_point import RunInterrupted
from .actions import all_fixes
from .language_server import PackageServer
from .linted import Linted

REMEMBERED = 100
"""Actions whose edits are known to have been given; an editor runs the command of one right behind its edit."""

CHANGED = "rospkg: the text has changed meanwhile, nothing was fixed"


class FixingAll:
    """The edits that go on to be made, and which were given to the editor, by the keys of their actions."""

    def __init__(self, server: PackageServer) -> None:
        self.server = server
        self.going_on: dict[str, asyncio.Task[types.WorkspaceEdit | None]] = {}
        self.given: deque[str] = deque(maxlen=REMEMBERED)
        self.withheld: deque[str] = deque(maxlen=REMEMBERED)
        """Those whose edits came too late for the front."""
        self.applying: set[asyncio.Task[None]] = set()

    def edit(self, key: str, path: Path) -> asyncio.Task[types.WorkspaceEdit | None]:
        """Return what makes the edit of an action, or makes it already; None comes of it where the text changes."""
        if key not in self.going_on:
            self.going_on[key] = asyncio.get_running_loop().create_task(self.make(path))
            self.going_on[key].add_done_callback(lambda _: self.going_on.pop(key, None))
        return self.going_on[key]

    async def make(self, path: Path) -> types.WorkspaceEdit | None:
        """Return the edit, one of nothing where making it failed."""
        live, linted = self.server.workspaces.at(path), await self.server.linted_at(path)
        if live is None or linted is None:
            return None
        try:
            return await asyncio.get_running_loop().run_in_executor(self.server.linting, fixes_of, linted, path)
        except Exception:
            self.server.crashed(live, path, "fix all")
            return types.WorkspaceEdit()

    async def edit_in_time(self, key: str, path: Path) -> types.WorkspaceEdit | None:
        """Return the edit; None where it is not ready, and goes on to be made for the command."""
        try:
            found = await self.server.in_time(asyncio.shield(self.edit(key, path)))
        except JsonRpcContentModified:
            return None
        if found is not None and key not in self.withheld:
            self.given.append(key)
        return found

    def withhold(self, key: str) -> None:
        """Note that the editor got the answer that the edit is not ready, even if it is by now."""
        self.withheld.append(key)
        if key in self.given:
            self.given.remove(key)

    def apply_later(self, key: str, path: Path) -> None:
        """Let the editor make the edit of an action when it is ready, if it has not got it yet."""
        if key not in self.given:
            task = asyncio.get_running_loop().create_task(self.apply(self.edit(key, path)))
            self.applying.add(task)
            task.add_done_callback(self.applying.discard)

    async def apply(self, making: asyncio.Task[types.WorkspaceEdit | None]) -> None:
        edit = await making
        if edit is None:
            self.server.window_show_message(types.ShowMessageParams(types.MessageType.Info, CHANGED))
        elif edit.document_changes:
            await self.server.workspace_apply_edit_async(types.ApplyWorkspaceEditParams(edit, "rospkg: fix all"))


def fixes_of(linted: Linted, path: Path) -> types.WorkspaceEdit | None:
    """Return all safe fixes of a package; None where the texts changed before they were found."""
    try:
        return all_fixes(linted, path)
    except RunInterrupted:
        return None
