"""The facts and the findings of the packages of a workspace, kept with what they were made from."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Set
from typing import Any

from ...cache.kept_file import load, save
from ...disk import DiskTree
from ...light_dataclasses import dataclass, field
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from .answer_digests import AnswerDigests
from .plain import from_plain, to_plain
from .recorded_facts import Question
from .recorded_tree import Read, found_again, found_at, listing


@dataclass(frozen=True)
class Observed:
    """What was asked while a package was read and checked."""

    files: str
    """The listing, as a digest."""
    reads: dict[str, Read]
    """By paths in the package."""
    above: dict[str, Read]
    """By paths from the root of the run."""
    noted: frozenset[Question] = frozenset()
    """Of the workspace."""


@dataclass
class KeptPackage:
    """What is kept of one package; it holds where all else is as it was."""

    files: str
    """The listing, as a digest."""
    reads: list[Read]
    above: list[Read]
    facts: Any
    """As plain data."""
    asked: list[tuple[list[str], str]] = field(default_factory=list)
    results: Any = None
    """As plain data; None where its rules did not run."""


@dataclass
class KeptPackages:
    """The file of one workspace. Facts need `facts_key` to be the same, findings `rules_key` too."""

    path: str
    tree: DiskTree
    facts_key: str
    rules_key: str
    kept: dict[str, KeptPackage] = field(default_factory=dict)
    is_refreshed: bool = False
    """Whether a file was read that looks different, and is not."""
    seen_above: dict[str, Read] = field(default_factory=dict)

    def known_facts(self, folders: Iterable[str]) -> dict[str, PackageFacts]:
        """Return the facts of the packages whose files are as they were."""
        known = self.load()
        found = {}
        for folder in folders:
            try:
                if folder in known and self.is_unchanged(folder, package := KeptPackage(*known[folder])):
                    found[folder] = from_plain(package.facts)
                    self.kept[folder] = package
            except (LookupError, TypeError, ValueError):
                continue
        return {folder: facts for folder, facts in found.items() if isinstance(facts, PackageFacts)}

    def unchecked(self) -> frozenset[str]:
        """Return the packages whose facts are known, and whose findings are not."""
        return frozenset(folder for folder, package in self.kept.items() if package.results is None)

    def load(self) -> dict[str, Any]:
        """Return what the file has, without findings where they are of other rules."""
        fields = load(self.path)
        if fields is None or len(fields) != 3 or fields[0] != self.facts_key:
            return {}
        import json

        try:
            found = json.loads(fields[2])
        except ValueError:
            return {}
        if fields[1] != self.rules_key:
            return {folder: [*each[:4], [], None] for folder, each in found.items()}
        return dict(found)

    def is_unchanged(self, folder: str, package: KeptPackage) -> bool:
        """Return whether all files that were asked for are as they were; brings their signatures up to date."""
        tree = self.tree.sub(folder)
        if listing(tree) != package.files:
            return False
        for number, read in enumerate(package.reads):
            now = found_again(tree, (read[0], read[1], read[2]))
            if now[1] != read[1]:
                return False
            self.is_refreshed |= now[2] != read[2]
            package.reads[number] = now
        return all(self.above(path)[1] == answer for path, answer, _ in package.above)

    def above(self, path: str) -> Read:
        """Return what lies at a path from the root of the run; looked up once."""
        if path not in self.seen_above:
            self.seen_above[path] = found_at(self.tree, path)
        return self.seen_above[path]

    def known_results(self, workspace: Workspace, folders: Iterable[str]) -> dict[str, Any]:
        """Return the findings, as `keep` got them, of the packages to which the workspace answers as it did."""
        answers, found = AnswerDigests(workspace), {}
        for folder in folders:
            package = self.kept.get(folder)
            if package is None or package.results is None:
                continue
            try:
                if all(answers.digest(tuple(question)) == digest for question, digest in package.asked):
                    found[folder] = from_plain(package.results)
            except (LookupError, TypeError, ValueError):
                continue
        return found

    def keep(
        self,
        workspace: Workspace,
        observed: Mapping[str, Observed],
        results: Mapping[str, Any],
        failed: Set[str],
    ) -> None:
        """Keep what was found anew, along with what still holds; `failed` packages are not kept."""
        if not observed and not self.is_refreshed:
            return
        answers = AnswerDigests(workspace)
        for folder, seen in observed.items():
            facts = workspace.at(folder)
            if folder not in failed and type(facts) is PackageFacts:  # facts on demand are not all there
                self.kept[folder] = self.package(facts, seen, answers, results.get(folder))
        import json

        data = {
            folder: [p.files, p.reads, p.above, p.facts, p.asked, p.results] for folder, p in sorted(self.kept.items())
        }
        save(self.path, [self.facts_key, self.rules_key, json.dumps(data, separators=(",", ":"))])

    def package(self, facts: PackageFacts, seen: Observed, answers: AnswerDigests, results: Any) -> KeptPackage:
        """Return what is to be kept of a package: of one whose facts were known, what was asked then counts, too."""
        before = self.kept.get(facts.folder)
        reads = {**seen.reads, **{read[0]: read for read in (before.reads if before else ())}}
        above = {**seen.above, **{read[0]: read for read in (before.above if before else ())}}
        return KeptPackage(
            seen.files,
            [reads[path] for path in sorted(reads)],
            [above[path] for path in sorted(above)],
            to_plain(facts),
            [(list(question), digest) for question, digest in answers.of(seen.noted)],
            None if results is None else to_plain(results),
        )
