"""What reads and checks the packages of a run: this process alone, or (`process_pool.py`) several."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from ...package.package_facts import PackageFacts
from ...package.rule_settings import RuleSettings
from ...package.workspace import Workspace
from ...ros.distros import Targets
from ...tree import Tree
from ..reuse.kept_packages import Observed
from .package_results import PackageResults
from .scope import Scope
from .worker import Worker

SERIAL_BELOW = 40
"""With fewer packages starting processes costs more than it saves."""


class Pool:
    """Runs everything in this process; `engine.run.process_pool` has the one that uses several."""

    def __init__(self, tree: Tree, scope: Scope, targets: Targets, settings: RuleSettings) -> None:
        self.worker = Worker(tree, scope.folders, targets, settings, scope.name, scope.selected)

    def collect_facts(self, wanted: Collection[str]) -> list[PackageFacts]:
        return self.worker.collect_facts(wanted)

    def run_rules(self, workspace: Workspace, codes: Sequence[str], wanted: Collection[str]) -> list[PackageResults]:
        return self.worker.run_rules(workspace, codes, wanted)

    def observed(self) -> dict[str, Observed]:
        """Return what was asked while packages were read and checked, where the run is traced."""
        return self.worker.observed()

    def close(self) -> None:
        """Release what the pool holds."""
