"""The workspace as one package sees it: what the package asks about others is noted."""

from __future__ import annotations

from ...package.facts_by_value import ValuesField
from ...package.launch.included_arguments import IncludedArguments
from ...package.launch.workspace_launch_files import WorkspaceLaunchFiles
from ...package.package_facts import PackageFacts
from ...package.params.parameter_index import ParameterIndex
from ...package.plugin import Plugin
from ...package.workspace import Workspace
from ...ros.distros import Targets
from ...ros.names import NameKind
from .recorded_facts import Question, RecordedFacts
from .recorded_parameters import RecordedParameterIndex

GIVEN = ("is_complete", "prefix_names", "repositories", "index", "incomplete", "missing_repositories", "cmake_projects")
"""What is the same for all packages of a run: `rules_key` of KeptPackages holds it."""


class RecordedWorkspace(Workspace):
    """Answers as the workspace does; the facts of the package itself are given as they are.

    What is not overridden here is computed from recorded facts: the methods below only make the questions finer.
    """

    def __init__(self, real: Workspace, own: str) -> None:
        self.real, self.own = real, own
        self.noted: set[Question] = set()
        vars(self).update({name: getattr(real, name) for name in GIVEN})
        self._facts: dict[str, PackageFacts] = {}

    __eq__ = object.__eq__
    __hash__ = object.__hash__

    def recorded(self, facts: PackageFacts) -> PackageFacts:
        if facts.folder == self.own:
            return facts
        if facts.folder not in self._facts:
            self._facts[facts.folder] = RecordedFacts(facts, self.noted)
        return self._facts[facts.folder]

    @property
    def packages(self) -> tuple[PackageFacts, ...]:
        self.noted.add(("folders",))
        return tuple(map(self.recorded, self.real.packages))

    def noted_of_all(self, *fields: str) -> Workspace:
        """Return the whole workspace, whose indexes hold some fields of all packages."""
        self.noted.add(("folders",))
        self.noted.update(("all", name) for name in fields)
        return self.real

    @property
    def parameters(self) -> ParameterIndex:
        return RecordedParameterIndex(self.noted_of_all("parameters").parameters, self.recorded)

    @property
    def launch(self) -> WorkspaceLaunchFiles:
        return self.noted_of_all("launch_summaries").launch

    @property
    def included_arguments(self) -> IncludedArguments:
        return self.noted_of_all("name", "launch_files").included_arguments

    @property
    def selected(self) -> frozenset[str]:
        self.noted.add(("selected",))
        return self.real.selected

    @property
    def names(self) -> frozenset[str]:
        self.noted.add(("names",))
        return self.real.names

    def named(self, name: str) -> PackageFacts | None:
        self.noted.add(("named", name))
        if self.real.nearest:
            self.noted.update((("folders",), ("all", "name")))  # the nearest one may be another
        found = self.real.named(name)
        return None if found is None else self.recorded(found)

    def at(self, folder: str) -> PackageFacts:
        if folder != self.own:
            self.noted.add(("folders",))
        return self.recorded(self.real.at(folder))

    def package_at(self, path: str) -> str:
        self.noted.add(("package_at", path))
        return self.real.package_at(path)

    def kind_of(self, name: str, targets: Targets | None = None) -> NameKind:
        self.noted.add(("is_name", name))
        return self.real.kind_of(name, targets)

    def is_available(self, name: str) -> bool:
        self.noted.add(("is_name", name))
        return self.real.is_available(name)

    def having(self, field: ValuesField, *value: str) -> tuple[PackageFacts, ...]:
        self.noted.add(("having", field, *value))
        return tuple(map(self.recorded, self.real.having(field, *value)))

    def needing(self, name: str) -> tuple[PackageFacts, ...]:
        self.noted.add(("needing", name))
        return tuple(map(self.recorded, self.real.needing(name)))

    def is_built_against(self, name: str) -> bool:
        self.noted.add(("is_built_against", name))
        return self.real.is_built_against(name)

    def loaders_of(self, base: str) -> frozenset[str]:
        self.noted.add(("loaders_of", base))
        return self.real.loaders_of(base)

    def bases_loaded_from(self, package: str) -> frozenset[str]:
        self.noted.add(("bases_loaded_from", package))
        return self.real.bases_loaded_from(package)

    def plugins_of(self, base: str) -> list[Plugin]:
        self.noted.add(("plugins_of", base))
        return self.real.plugins_of(base)

    def with_header(self, header: str) -> frozenset[str]:
        self.noted.add(("with_header", header))
        return self.real.with_header(header)

    def providers_of(self, module: str) -> tuple[str, ...]:
        self.noted.add(("providers_of", module))
        return self.real.providers_of(module)
