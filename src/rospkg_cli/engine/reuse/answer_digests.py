"""Digests of what a workspace answers to noted questions, by which kept results are found to hold still."""

from __future__ import annotations

from collections.abc import Iterable

from ...package.workspace import Workspace
from .plain import digest_of
from .recorded_facts import Question

METHODS = frozenset(
    "package_at is_built_against loaders_of bases_loaded_from plugins_of with_header providers_of".split()
)  # fmt: skip
"""The questions that are methods of the workspace."""


class AnswerDigests:
    """The digests of a workspace's answers, each computed once."""

    def __init__(self, workspace: Workspace) -> None:
        self.workspace = workspace
        self.known: dict[Question, str] = {}
        self.pairs: dict[Question, tuple[Question, str]] = {}
        """Questions with their digests, one object for all packages that ask: thousands ask the same hundreds."""

    def digest(self, question: Question) -> str:
        """Return the digest of an answer; "" where the question makes no sense in this workspace."""
        if question not in self.known:
            try:
                self.known[question] = digest_of(self.answer(*question))
            except (AttributeError, LookupError, TypeError):
                self.known[question] = ""
        return self.known[question]

    def answer(self, what: str, *arguments: str) -> object:
        real = self.workspace
        if what == "folders":
            return tuple(facts.folder for facts in real.packages)
        if what == "all":
            return tuple(getattr(facts, arguments[0]) for facts in real.packages)
        if what == "field":
            return getattr(real.at(arguments[0]), arguments[1])
        if what == "named":
            found = real.named(arguments[0])
            return None if found is None else found.folder
        if what == "is_name":
            return arguments[0] in real.names
        if what in ("selected", "names"):
            return getattr(real, what)
        if what in ("having", "needing"):
            return tuple(facts.folder for facts in getattr(real, what)(*arguments))
        if what not in METHODS:
            raise LookupError(what)
        answer = getattr(real, what)(*arguments)
        return tuple(answer) if isinstance(answer, list) else answer

    def of(self, noted: Iterable[Question]) -> tuple[tuple[Question, str], ...]:
        """Return the questions with their digests; a field that most packages were asked for counts as asked of all."""
        noted, counts = set(noted), dict[str, int]()
        for question in noted:
            if question[0] == "field":
                counts[question[2]] = counts.get(question[2], 0) + 1
        common = {name for name, count in counts.items() if count > 8 and 2 * count > len(self.workspace.packages)}
        noted = {each for each in noted if each[0] != "field" or each[2] not in common}
        noted |= {("all", name) for name in common} | ({("folders",)} if common else set())
        pairs = ((each, self.digest(each)) for each in sorted(noted))
        return tuple(self.pairs.setdefault(pair[0], pair) for pair in pairs)
