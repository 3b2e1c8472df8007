"""Everything that is known about the packages of the run, for the one that is checked."""

from __future__ import annotations

from functools import cached_property
from typing import Any, TypeVar, cast

from ..light_dataclasses import dataclass, replace
from ..ros.config_files import is_cased
from ..ros.distros import Distro, Targets
from ..ros.imports import providers
from ..ros.names import BUILT_IN, NameKind, Names
from .facts_by_value import FactsByValue, ValuesField
from .launch.included_arguments import IncludedArguments
from .launch.workspace_launch_files import WorkspaceLaunchFiles
from .missing_repositories import is_called, may_hold
from .package_facts import PackageFacts
from .package_indexes import (
    by_build_dependency,
    by_dependency,
    by_header_folder,
    loaders_by_base,
    of_one_name,
    shared_folders,
)
from .params.parameter_index import ParameterIndex
from .plugin import Plugin

IndexT = TypeVar("IndexT")


@dataclass(frozen=True)
class Workspace:
    packages: tuple[PackageFacts, ...] = ()
    """Of all packages found, sorted by folder."""
    selected: frozenset[str] = frozenset()
    """The folders of the packages that the user selected."""
    is_complete: bool = True
    """False where, for example, a `.repos` file lists packages that are not here: then no name is certainly unknown."""
    prefix_names: frozenset[str] = frozenset()
    """Names found in AMENT_PREFIX_PATH and /opt/ros: they may silence a finding, never cause one."""

    repositories: tuple[frozenset[str], ...] = ()
    """The folders of the packages of each repository, as far as repositories are known."""

    index: Names = BUILT_IN
    """The names of rosdistro and rosdep."""

    incomplete: str = ""
    """Why it is not complete, in a sentence that names the file."""

    missing_repositories: frozenset[str] = frozenset()
    """The repositories that are listed and not here; empty where that is unknown."""

    cmake_projects: tuple[tuple[str, str], ...] = ()
    """The names and folders of the plain CMake projects, which colcon builds and rosdep does not know."""

    nearest: tuple[PackageFacts, ...] = ()
    """Of packages with the same name, the one that is found from the package that is checked."""

    @cached_property
    def _by_name(self) -> dict[str, PackageFacts]:
        return {facts.name: facts for facts in (*reversed(self.packages), *self.nearest)}

    def seen_from(self, folder: str) -> Workspace:
        """Return the workspace as the package in a folder sees it.

        A repository may hold several workspaces: of packages with one name, the one that shares most folders is found.
        """
        if not self.repeated:
            return self
        chosen = tuple(max(each, key=lambda facts: shared_folders(facts.folder, folder)) for each in self.repeated)
        places = tuple(facts.folder for facts in chosen)
        if places not in self._views:
            self._views[places] = replace(self, nearest=chosen)
        return self._views[places]

    @cached_property
    def repeated(self) -> tuple[tuple[PackageFacts, ...], ...]:
        """The packages of each name that several have."""
        return of_one_name(self.packages)

    @cached_property
    def _views(self) -> dict[tuple[str, ...], Workspace]:
        return {}

    @cached_property
    def _by_folder(self) -> dict[str, PackageFacts]:
        return {facts.folder: facts for facts in self.packages}

    @cached_property
    def parameters(self) -> ParameterIndex:
        """What the code of all packages declares."""
        return ParameterIndex(self.packages)

    @cached_property
    def launch(self) -> WorkspaceLaunchFiles:
        """The launch files of all packages."""
        return WorkspaceLaunchFiles(each for facts in self.packages for each in facts.launch_summaries)

    @cached_property
    def included_arguments(self) -> IncludedArguments:
        """What the launch files of all packages take; of packages of one name, those of the first."""
        first = self._by_name.values()
        return IncludedArguments((facts.name, each) for facts in first for each in facts.launch_files)

    @cached_property
    def _indexes(self) -> dict[type, Any]:
        return {}

    def index_of(self, kind: type[IndexT]) -> IndexT:
        """Return the one index of a class that checks fill with what they work out of this workspace, empty at first.

        It is asked with the workspace and does not hold it, or the two could not be freed at once.
        """
        if kind not in self._indexes:
            self._indexes[kind] = kind()
        return cast(IndexT, self._indexes[kind])

    @cached_property
    def names(self) -> frozenset[str]:
        return frozenset(self._by_name)

    def named(self, name: str) -> PackageFacts | None:
        return self._by_name.get(name)

    def at(self, folder: str) -> PackageFacts:
        """Return the facts of the package in a folder; raises KeyError."""
        return self._by_folder[folder]

    def package_at(self, path: str) -> str:
        """Return the name of the innermost package that contains a path of the run; "" for none."""
        while path:
            path = path.rpartition("/")[0]
            if path in self._by_folder:
                return self._by_folder[path].name
        return ""

    @cached_property
    def _by_value(self) -> FactsByValue:
        return FactsByValue(self.packages)

    def having(self, field: ValuesField, *value: str) -> tuple[PackageFacts, ...]:
        """Return the packages of which a field of their facts holds a value (several strings for a tuple of them)."""
        return self._by_value.having(field, *value)

    def installing(self, top: str) -> str:
        """Return the first package that installs modules below a name without dots; "" where none does."""
        return self._by_value.installing(top)

    def needing(self, name: str) -> tuple[PackageFacts, ...]:
        """Return the other packages that declare a dependency, whatever its tag."""
        return tuple(facts for facts in self._needing.get(name, ()) if facts.name != name)

    @cached_property
    def _needing(self) -> dict[str, list[PackageFacts]]:
        return by_dependency(self.packages)

    def is_needed(self, name: str) -> bool:
        """Return whether another package depends on one: it may open any of its files."""
        return bool(self.needing(name))

    def is_built_against(self, name: str) -> bool:
        """Return whether another package needs one for its build: it may look for it with `find_package()`."""
        return any(other != name for other in self._builders.get(name, ()))

    @cached_property
    def _builders(self) -> dict[str, set[str]]:
        return by_build_dependency(self.packages)

    def kind_of(self, name: str, targets: Targets | None = None) -> NameKind:
        """Return the kind of a name in package.xml; unknown only where no other source can provide it."""
        if name in self._by_name:
            return NameKind.PACKAGE
        found = self.index.kind_of(name, targets)
        unsure = not self.is_complete or name in self.prefix_names
        return NameKind.CANT_TELL if found is NameKind.UNKNOWN and unsure else found

    def is_available(self, name: str) -> bool:
        """Return whether a package is around, or installed on this machine."""
        return name in self._by_name or name in self.prefix_names

    def is_marked(self, name: str) -> bool:
        """Return whether a package is found under a name that is not its own (SET401), and no other package has it."""
        return not self.is_available(name) and bool(self.having("other_markers", name))

    def is_cased(self, name: str) -> bool:
        """Return whether CMake certainly finds a package by no other spelling of the case: ament's `<Name>Config`."""
        facts = self.named(name)
        return is_cased(name) or (facts is not None and facts.build_type == "ament_cmake")

    def folder_of_project(self, name: str) -> str:
        """Return where a plain CMake project lies; "" where none has the name."""
        return dict(self.cmake_projects).get(name, "")

    def resolves(self, name: str, distro: Distro) -> bool | None:
        """Return whether a name can be resolved on a distribution, without what is not here; None if unknown."""
        return self.is_available(name) or self.index.resolves(name, distro)

    def may_lack(self, name: str) -> bool:
        """Return whether a repository that is listed and not here may hold a package, as far as they are known."""
        return bool(self.missing_repositories) and may_hold(self.missing_repositories, name)

    def is_listed(self, name: str) -> bool:
        """Return whether a repository that is listed and not here is called like a package, which is no slip then."""
        return is_called(self.missing_repositories, name)

    @cached_property
    def _loading(self) -> dict[str, set[str]]:
        return loaders_by_base(self.packages, self._is_package)

    def _is_package(self, name: str) -> bool:
        return self.is_available(name) or self.kind_of(name) is NameKind.PACKAGE

    def loaders_of(self, base: str) -> frozenset[str]:
        """Return the packages whose plugins of a base class are loaded, as far as that is known."""
        return frozenset(self._loading.get(base, ()))

    def bases_loaded_from(self, package: str) -> frozenset[str]:
        """Return the base classes whose plugins must be exported to a package, as far as that is known."""
        return frozenset(base for base, packages in self._loading.items() if package in packages)

    def plugins_of(self, base: str) -> list[Plugin]:
        """Return the described plugins of a base class."""
        return [plugin for facts in self.packages for plugin in facts.plugins if plugin.base == base]

    @cached_property
    def _by_headers(self) -> dict[str, set[str]]:
        return by_header_folder(self.packages)

    def with_header(self, header: str) -> frozenset[str]:
        """Return the packages of the workspace that have the folder of a header."""
        return frozenset(self._by_headers.get(header.rpartition("/")[0], ()))

    def providers_of(self, module: str) -> tuple[str, ...]:
        """Return what provides an import: a package of the workspace, a ROS package, a rosdep key; empty where unknown.

        Each of the names is sufficient, and the first is the one to recommend.
        """
        top = module.partition(".")[0]
        first = self.installing(top)
        around = [first] if first else []
        if top in self._by_name and top not in around:
            around.append(top)
        return tuple(around) or providers(module, self.index).names
