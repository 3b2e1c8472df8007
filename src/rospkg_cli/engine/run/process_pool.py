"""Spread the packages over processes: each reads its own, and checks what it has read."""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from concurrent.futures import Future, ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from typing import TypeVar

from ...disk_trace import Trace, current_trace, start_trace
from ...package.collect_facts import unknown_facts
from ...package.package_facts import PackageFacts
from ...package.rule_settings import RuleSettings
from ...package.run_events import RuleCrash
from ...package.workspace import Workspace
from ...ros.distros import Targets
from ...tree import Tree
from ..reuse.kept_packages import Observed
from .package_results import PackageResults
from .parts import parts_of
from .pool import Pool
from .rule_plugins import load_plugins
from .scope import Scope
from .worker import Worker

T = TypeVar("T")

_worker: Worker | None = None


class ProcessPool(Pool):
    """A process for each part of the packages, which keeps what it has read until it runs the rules."""

    def __init__(self, tree: Tree, scope: Scope, targets: Targets, settings: RuleSettings, jobs: int) -> None:
        self.name = scope.name
        self.parts = parts = parts_of(scope.folders, tree.files(), jobs)
        arguments = (targets, settings, scope.name, current_trace() is not None)
        self.workers = [
            ProcessPoolExecutor(1, initializer=start_worker, initargs=(tree, part, *arguments)) for part in parts
        ]

    def everywhere(self, call: Callable[..., list[T]], lost: Callable[[str], T], *arguments: object) -> list[T]:
        """Call a function in every process; `lost` returns the result for a package whose process died."""
        futures: list[Future[list[T]]] = []
        for worker in self.workers:
            try:
                futures.append(worker.submit(call, *arguments))
            except BrokenProcessPool as error:
                futures.append(Future())
                futures[-1].set_exception(error)
        found: list[T] = []
        for future, part in zip(futures, self.parts, strict=True):
            try:
                found += future.result()
            except BrokenProcessPool:
                found += map(lost, part)
        return found

    def collect_facts(self, wanted: Collection[str]) -> list[PackageFacts]:
        found = self.everywhere(gather_facts, lambda folder: unknown_facts(folder, self.name), wanted)
        return [each for each in found if each.folder in wanted]

    def run_rules(self, workspace: Workspace, codes: Sequence[str], wanted: Collection[str]) -> list[PackageResults]:
        found = self.everywhere(
            check_packages, lambda folder: lost_package(folder, workspace), workspace, codes, wanted
        )
        if (trace := current_trace()) is not None:
            for other in self.everywhere(asked_of_the_disk, lambda _: Trace()):
                trace.add(other)
        return [each for each in found if each.folder in wanted]

    def observed(self) -> dict[str, Observed]:
        found = self.everywhere(observed_packages, lambda _: None)
        return {folder: seen for each in found if each for folder, seen in each.items()}

    def close(self) -> None:
        for worker in self.workers:
            worker.shutdown()


def lost_package(folder: str, workspace: Workspace) -> PackageResults:
    """Return what is left of a package whose process died: a crash."""
    path = f"{folder}/package.xml" if folder else "package.xml"
    error = "its process was ended by the system; try --jobs 1"
    return PackageResults(
        folder, crashes=(RuleCrash("the whole package", workspace.at(folder).name, path, error, "check of"),)
    )


def start_worker(
    tree: Tree, folders: Sequence[str], targets: Targets, settings: RuleSettings, name: str, is_traced: bool
) -> None:
    global _worker
    if is_traced:
        start_trace()
    load_plugins(settings.plugins)
    _worker = Worker(tree, folders, targets, settings, name)


def gather_facts(wanted: Collection[str]) -> list[PackageFacts]:
    assert _worker is not None
    return _worker.collect_facts(wanted)


def asked_of_the_disk() -> list[Trace]:
    trace = current_trace()
    return [] if trace is None else [trace]


def observed_packages() -> list[dict[str, Observed] | None]:
    assert _worker is not None
    return [_worker.observed()]


def check_packages(workspace: Workspace, codes: Sequence[str], wanted: Collection[str]) -> list[PackageResults]:
    assert _worker is not None
    return _worker.run_rules(workspace, codes, wanted)
