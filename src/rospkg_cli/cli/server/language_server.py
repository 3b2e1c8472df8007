"""The server: what is open in an editor, the runs over it, and what was found."""

from __future__ import annotations

import asyncio
import traceback
from collections.abc import Awaitable, Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import TypeVar

from lsprotocol import types
from pygls.lsp.server import LanguageServer
from pygls.workspace import PositionCodec

from ... import __version__
from ...engine.live.safe_point import RightOfWay, RunInterrupted
from ...package.run_events import RuleCrash
from ...user_error import UserError
from .in_time import in_time
from .lint_loop import LintLoop
from .linted import Linted
from .live_lint import LintOrder, LiveLint, Scene
from .live_workspace import LiveWorkspace
from .open_workspaces import OpenWorkspaces
from .publication import Publication
from .refusal import LIMIT

T = TypeVar("T")


class PackageServer(LanguageServer):
    """All but the runs and the lookups, which have a thread each, goes on in the event loop."""

    def __init__(self) -> None:
        super().__init__("rospkg", __version__)
        self.workspaces = OpenWorkspaces()
        self.shown = Publication(self)
        self.lints = LintLoop(self.lint_all)
        self.way = RightOfWay()
        """Taken by what is asked while a run goes on."""
        self.limit = LIMIT
        """Seconds within which what is asked is answered or refused."""
        self.reports_changes = False
        """Whether the editor reports what changes on disk."""
        self.linting, self.looking_up = ThreadPoolExecutor(1, "lint"), ThreadPoolExecutor(1, "lookup")

    async def lint_all(self) -> bool:
        """Lint each workspace; return whether all packages are judged."""
        for live in self.workspaces:
            await self.lint(live)
        self.forget_answered()
        self.shown.forget(self.workspaces.by_folder.keys())
        return all(live.is_finished for live in self.workspaces)

    async def lint(self, live: LiveWorkspace) -> None:
        """Lint a workspace in the background, and publish the findings."""
        order, loop, codec = (
            live.order(self.way, is_reported=self.reports_changes),
            asyncio.get_running_loop(),
            self.workspace.position_codec,
        )

        def begins(scene: Scene) -> None:
            loop.call_soon_threadsafe(live.begin, scene)
            loop.call_soon_threadsafe(self.lints.tell)

        try:
            linted = await loop.run_in_executor(self.linting, lint, live.lint, order, codec, begins)
            if linted is None:
                live.give_back(order)
            elif live.take(linted):
                self.publish(live)
        except Exception as error:
            live.fail(order)
            self.tell(live, error)
        finally:
            self.lints.tell()

    def publish(self, live: LiveWorkspace) -> None:
        """Show what was found in the files of a workspace; those that lie in an inner one are shown by that."""
        if live.linted is None or self.workspaces.by_folder.get(live.folder) is not live:
            return
        linted = live.linted
        if live.crashes:
            linted = Linted.of(linted.run, linted.codec, live.crashes.values())
        own = {path: each for path, each in linted.diagnostics.items() if self.workspaces.shows(live, path)}
        uris = {path: text.uri for path, text in self.workspaces.texts.items()}
        self.shown.send(live.folder, own, uris, live.asked)
        live.asked.clear()

    def forget_answered(self) -> None:
        """Let go of what pygls keeps of each notification that it has handled itself: 3 KB for each key (pygls 2.1)."""
        kept = getattr(self.protocol, "_request_futures")  # noqa: B009  # private there
        for each in [number for number, future in kept.items() if future.done()]:
            del kept[each]

    def tell(self, live: LiveWorkspace, error: Exception) -> None:
        """Say why a run came to nothing: once, until there is another reason."""
        said = f"rospkg: {error}"
        if not isinstance(error, UserError):
            said = f"rospkg: internal error, please report it: {error!r}"
            self.window_log_message(types.LogMessageParams(types.MessageType.Error, traceback.format_exc()))
        if said != live.said:
            live.said = said
            self.window_show_message(types.ShowMessageParams(types.MessageType.Error, said))

    def crashed(self, live: LiveWorkspace, path: Path, what: str) -> None:
        """Show that something other than a run failed at a file, with the exception that is being handled."""
        scene, error = live.scene, traceback.format_exc()
        self.window_log_message(types.LogMessageParams(types.MessageType.Error, error))
        if scene and path.is_relative_to(scene.root):
            place = path.relative_to(scene.root).as_posix()
            live.crashes[path] = RuleCrash(what, path.parent.name, place, error, "answer to")
            self.publish(live)

    async def in_time(self, answer: Awaitable[T]) -> T:
        """Return an answer; raises JsonRpcContentModified where it takes longer than the editor is to wait."""
        return await in_time(answer, self.limit)

    async def linted_at(self, path: Path) -> Linted | None:
        """Return the run that saw all texts as they are in the editor, once it has ended; None where none comes."""
        live = self.workspaces.at(path)
        if live is None:
            return None
        if not (live.is_current or live.has_failed):
            self.lints.hurry()
        await self.lints.until(lambda: live.is_current or live.has_failed)
        return live.linted if live.is_current else None


def lint(live: LiveLint, order: LintOrder, codec: PositionCodec, begins: Callable[[Scene], None]) -> Linted | None:
    """Return what a run finds, made ready to be shown; None where it was interrupted."""
    try:
        found = Linted.of(live.run(order, begins), codec)
        found.make_ready()
    except RunInterrupted:
        return None
    return found
