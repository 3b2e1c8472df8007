"""Faults of Python code that never run today, as another fault or an endless wait before them ends the run."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from functools import cached_property

from ...checks.python.installed_modules import InstalledModules
from ...checks.refused_own_calls import RefusedOwnCalls
from ...files import PackageFiles
from ...finding import Finding, Location, Severity
from ...languages.python.file import PythonFile
from ...languages.python.stopped_places import StoppedPlaces
from ...light_dataclasses import dataclass, replace
from ...package.package_facts import PackageFacts
from ...package.python_modules import PythonModules
from ...package.run_events import RuleCrash
from ...source import Span
from .failing_modules import FailingModules
from .finding_builder import AT_RUN
from .milder import RuleResults
from .stopping_places import StoppingPlaces, all_places, is_mild_stop, location
from .waiting_modules import WaitingModules

FIRST = "this raises first"
BEHIND = "; the run ends before, at another line"
WAITS = "nothing spins the node here, and so nothing ends this wait"
BEHIND_WAIT = "; the run does not come here, as a wait before it never ends"


@dataclass(frozen=True)
class EarlierFaults:
    files: PackageFiles
    modules: PythonModules
    facts: PackageFacts
    installed: InstalledModules | None = None
    refused: RefusedOwnCalls | None = None

    def milder(self, every: Sequence[Finding | RuleCrash]) -> RuleResults:
        """Return results with an info for each fault of a file that its program does not reach."""
        loud = [each for each in every if isinstance(each, Finding) and each.is_loud]
        mild = [each for each in every if isinstance(each, Finding) and is_mild_stop(each)]
        found: dict[int, Finding] = {}
        failing = self.failing_imports(loud)
        for path in {each.location.path for each in loud if each.code in AT_RUN}:
            file = self.modules.at(path.removeprefix(f"{self.files.folder}/" if self.files.folder else ""))
            if file is not None:
                spans = (at.span for each in mild for at in self.stops.of(each, path, file))
                refused = self.refused.in_file(file) if self.refused is not None else ()
                found |= self.in_file(path, file, loud, (*failing.get(file.path, ()), *spans, *refused))
                found |= self.behind_waits(path, file, [each for each in loud if id(each) not in found])
        return [found.get(id(each), each) for each in every]

    def failing_imports(self, loud: Sequence[Finding]) -> Mapping[str, Sequence[Span]]:
        """Return, by the path of a file, its imports of own modules whose import fails."""
        if self.installed is None:
            return {}
        start = f"{self.files.folder}/" if self.files.folder else ""

        def stops(file: PythonFile) -> list[Span]:
            return [at.span for each in loud for at in self.stops.of(each, f"{start}{file.path}", file)]

        return FailingModules(self.installed, stops).imports()

    def in_file(
        self, path: str, file: PythonFile, loud: Sequence[Finding], failing: Sequence[Span]
    ) -> dict[int, Finding]:
        """Return the milder findings of a file by the identities of those that they replace."""
        stops = {span: location(path, file, span) for span in failing}
        stops |= {at.span: at for each in loud for at in self.stops.of(each, path, file)}
        others = self.naming(file)
        places = StoppedPlaces(file, tuple(sorted(stops)), lambda name: is_in(name, others), is_raising=True)
        return self.behind(path, loud, places, [stops[span] for span in sorted(stops)])

    def behind_waits(self, path: str, file: PythonFile, loud: Sequence[Finding]) -> dict[int, Finding]:
        """Return the milder findings behind loops that nothing ends."""
        spans = tuple(sorted({*self.waiting.in_file(file)})) if self.waiting is not None else ()
        if not spans:
            return {}
        others = self.naming(file)
        places = StoppedPlaces(file, spans, lambda name: is_in(name, others))
        stops = [location(path, file, span) for span in spans]
        return self.behind(path, loud, places, stops, (WAITS, BEHIND_WAIT))

    @cached_property
    def stops(self) -> StoppingPlaces:
        return StoppingPlaces(self.facts)

    @cached_property
    def waiting(self) -> WaitingModules | None:
        return WaitingModules(self.installed) if self.installed is not None else None

    def behind(
        self,
        path: str,
        loud: Sequence[Finding],
        places: StoppedPlaces,
        stops: Sequence[Location],
        said: tuple[str, str] = (FIRST, BEHIND),
    ) -> dict[int, Finding]:
        first = next((each for each in stops if not places.has(each.span.start)), None)
        found: dict[int, Finding] = {}
        for each in loud if first is not None else ():
            own = each.code in AT_RUN and each.location.path == path
            if own and first is not None and all(places.has(at.span.start) for at in all_places(each, path)):
                related = (*each.related, (first, said[0]))
                message = each.message + said[1]
                found[id(each)] = replace(each, severity=Severity.INFO, message=message, related=related)
        return found

    def naming(self, file: PythonFile) -> list[str]:
        """Return the texts of the other files that name a module, and may use what is in it."""
        module = re.compile(rf"(?<!\w){re.escape(file.path.rpartition('/')[2].removesuffix('.py'))}(?!\w)")
        others = (each for each in self.files.paths if each.endswith(".py") and each != file.path)
        return [text for each in others if module.search(text := self.files.readable_text(each))]


def is_in(name: str, texts: Sequence[str]) -> bool:
    """Return whether a text has a name as a word."""
    having = [each for each in texts if name in each]
    return bool(having) and any(map(re.compile(rf"(?<!\w){re.escape(name)}(?!\w)").search, having))
