"""The facts and the findings of the packages of a workspace, in memory, with what they were made from."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Set
from typing import Any

from ...light_dataclasses import dataclass, field
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from ..reuse.answer_digests import AnswerDigests
from ..reuse.kept_packages import Observed
from ..reuse.recorded_facts import Question
from .safe_point import never

SOME = 50
"""Questions that are answered between two looks."""


@dataclass
class LivePackages:
    """What `Session.kept` asks for, as KeptPackages has it on disk; whoever changes a file says so by `forget`."""

    facts: dict[str, PackageFacts] = field(default_factory=dict)
    results: dict[str, Any] = field(default_factory=dict)
    asked: dict[str, tuple[tuple[Question, str], ...]] = field(default_factory=dict)
    """The questions of each package to the workspace, with the digests of the answers."""
    above: dict[str, Set[str]] = field(default_factory=dict)
    """The paths outside of each package that it asked for."""
    look: Callable[[], None] = never
    """Called every so often: a run may be interrupted there."""
    given: str = ""
    """What all findings depend on besides the packages: rules, settings, what lies around."""

    def forget(self, paths: Iterable[str], folders: Iterable[str]) -> None:
        """Forget what was made from some paths (from the root of the run), there or not, of packages in some folders.

        A path in no package may decide about all, but for those that only tools other than colcon look at.
        """
        folders = sorted(folders, key=len, reverse=True)
        for path in paths:
            own = next((each for each in folders if not each or path.startswith(f"{each}/")), None)
            readers = [each for each, asked in self.above.items() if path in asked]
            own_ones = [own] if own is not None else [] if is_of_a_tool(path) else list(self.facts)
            for folder in {*readers, *own_ones}:
                self.forget_package(folder)

    def forget_package(self, folder: str) -> None:
        for each in (self.facts, self.results, self.asked, self.above):
            each.pop(folder, None)

    def require(self, given: str) -> None:
        """Forget all findings where what they depend on is not what it was."""
        if given != self.given:
            self.given = given
            self.results.clear()

    def known_facts(self, folders: Iterable[str]) -> dict[str, PackageFacts]:
        """Return the facts of the packages whose files are as they were."""
        wanted = set(folders)
        for gone in self.facts.keys() - wanted:
            self.forget_package(gone)
        return dict(self.facts)

    def unchecked(self) -> frozenset[str]:
        """Return the packages whose facts are known, and whose findings are not."""
        return frozenset(self.facts.keys() - self.results.keys())

    def known_results(self, workspace: Workspace, folders: Iterable[str]) -> dict[str, Any]:
        """Return the findings of the packages to which the workspace answers as it did."""
        answers = AnswerDigests(workspace)
        return {folder: self.results[folder] for folder in folders if self.is_known(folder, answers)}

    def is_known(self, folder: str, answers: AnswerDigests) -> bool:
        """Return whether what is known of a package still holds."""
        for count, (question, digest) in enumerate(self.asked.get(folder, ())):
            if count % SOME == 0:
                self.look()
            if answers.digest(question) != digest:
                return False
        return folder in self.results

    def keep(
        self, workspace: Workspace, observed: Mapping[str, Observed], results: Mapping[str, Any], failed: Set[str]
    ) -> None:
        """Keep what was found anew; `failed` packages are not kept."""
        answers = AnswerDigests(workspace)
        for facts in workspace.packages:
            if type(facts) is PackageFacts and facts.folder not in failed:  # facts on demand are not all there
                self.facts[facts.folder] = facts
        for folder, seen in observed.items():
            if folder in results and folder in self.facts and folder not in failed:
                self.results[folder] = results[folder]
                self.asked[folder] = answers.of(seen.noted)
                self.above[folder] = frozenset(seen.above)


def is_of_a_tool(path: str) -> bool:
    """Return whether a path lies in a folder like .github: what lint reads of such names are files."""
    return any(part.startswith(".") for part in path.split("/")[:-1])
