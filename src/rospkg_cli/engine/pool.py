"""Spread the packages over processes: each reads its own, and checks what it has read."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from concurrent.futures import Future, ProcessPoolExecutor
from typing import TypeVar

from ..model.facts import PackageFacts
from ..model.settings import Settings
from ..model.workspace import Workspace
from ..ros.distros import Targets
from ..tree import Tree
from .plugged import plug_in
from .session import Pool, Scope
from .shard import Checked, Shard

T = TypeVar("T")

SERIAL_BELOW = 40
"""With fewer packages starting processes costs more than it saves."""

_shard: Shard | None = None


class ProcessPool(Pool):
    """One process a shard, so that the models a process has read are there when it checks."""

    def __init__(self, tree: Tree, scope: Scope, targets: Targets, settings: Settings, jobs: int) -> None:
        parts = [scope.folders[start::jobs] for start in range(min(jobs, len(scope.folders)))]
        self.workers = [
            ProcessPoolExecutor(1, initializer=start_shard, initargs=(tree, part, targets, settings, scope.name))
            for part in parts
        ]

    def everywhere(self, call: Callable[..., list[T]], *arguments: object) -> list[T]:
        futures: list[Future[list[T]]] = [worker.submit(call, *arguments) for worker in self.workers]
        return [each for future in futures for each in future.result()]

    def gather(self) -> list[PackageFacts]:
        return self.everywhere(gather_shard)

    def check(self, workspace: Workspace, codes: Sequence[str]) -> list[Checked]:
        return self.everywhere(check_shard, workspace, codes)

    def close(self) -> None:
        for worker in self.workers:
            worker.shutdown()


def start_shard(tree: Tree, folders: Sequence[str], targets: Targets, settings: Settings, name: str) -> None:
    global _shard
    plug_in(settings.plugins)
    _shard = Shard(tree, folders, targets, settings, name)


def gather_shard() -> list[PackageFacts]:
    assert _shard is not None
    return _shard.gather()


def check_shard(workspace: Workspace, codes: Sequence[str]) -> list[Checked]:
    assert _shard is not None
    return _shard.check(workspace, codes)
