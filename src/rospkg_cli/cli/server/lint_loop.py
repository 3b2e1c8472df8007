"""Runs in the background of what an editor asks: soon after a change, and never two at once."""

from __future__ import annotations

import asyncio
import gc
from collections.abc import Awaitable, Callable
from contextlib import suppress

PAUSE = 0.15
"""Seconds without a change after which packages are linted."""

MUCH = 3
"""Collections of the middle generation after which a full one is worth its time: 60,000 objects."""


class LintLoop:
    """Calls `lint_all` whenever something has changed and then rested, and again until it returns True."""

    def __init__(self, lint_all: Callable[[], Awaitable[bool]]) -> None:
        self.lint_all = lint_all
        self.has_changed = asyncio.Event()
        self.is_urgent = asyncio.Event()
        """Set where somebody waits for the run that is to come."""
        self.is_settled = asyncio.Event()
        """Set while the diagnostics are those of the texts in the editor, in all packages."""
        self.went_on = asyncio.Event()
        """Set, and another one put here, whenever a run has begun or ended."""
        self.task: asyncio.Task[None] | None = None
        self.is_alone = False
        """Whether all that this process holds is the server's."""

    def soon(self) -> None:
        """Let a run follow."""
        self.is_settled.clear()
        self.has_changed.set()
        if self.task is None or self.task.done():
            self.task = asyncio.get_running_loop().create_task(self.go_on())

    async def go_on(self) -> None:
        while True:
            await self.has_changed.wait()
            is_finished = False
            while self.has_changed.is_set() or not is_finished:
                while self.has_changed.is_set():
                    self.has_changed.clear()
                    await self.pause()
                is_finished = await self.lint_all()
                self.collect_garbage()
            if self.is_alone and not gc.get_freeze_count():
                gc.collect()
                gc.freeze()
            self.is_settled.set()

    async def pause(self) -> None:
        """Wait for more changes, unless somebody waits for the run."""
        with suppress(asyncio.TimeoutError):
            await asyncio.wait_for(self.is_urgent.wait(), PAUSE)
        self.is_urgent.clear()

    def collect_garbage(self) -> None:
        """Let go of what a run has left; what was known when all were judged for the first time is not looked at."""
        if self.is_alone and gc.get_freeze_count() and gc.get_count()[2] >= MUCH:
            gc.collect()

    def tell(self) -> None:
        """Wake those that wait for a run."""
        self.went_on.set()
        self.went_on = asyncio.Event()

    def hurry(self) -> None:
        """Let the next run begin without a pause."""
        self.is_urgent.set()

    async def until(self, holds: Callable[[], bool]) -> None:
        """Wait until something holds, looking after each step of a run."""
        while not holds():
            await self.went_on.wait()
