"""Packages that launch files use and package.xml does not declare (DEP103)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import cached_property
from typing import TYPE_CHECKING, Annotated

from ...files import PackageFiles
from ...lazy_regex import regex
from ...light_dataclasses import dataclass, replace
from ...package.cmake.cmake_project import CMake
from ...package.file_role import Role, role_of
from ...package.install_table import InstallTable
from ...package.launch.default_conditions import off_by_default
from ...package.launch.launch_file import LaunchFile
from ...package.launch.never_launched import never_shown
from ...package.launch.off_values import with_values
from ...package.python.python_imports import PackageImports, own_modules
from ...package.workspace import Workspace
from ...ros.implied_dependencies import IN_LAUNCH_FILES, IN_TESTS, LAUNCH, implied_by
from ...ros.imports import may_serve
from ...ros.names import NameKind
from ...source import Span
from ...suggest import begins_alike, is_misspelt, nearest
from ...unreadable import READABLE
from ..launch.example_files import is_example
from ..launch.idle_parts import idle_parts
from ..launch.launched_programs import is_program
from ..launch.package_references import NAME, PackageReference, package_references
from ..left_files import LeftFiles
from .brought_dependencies import brought_by
from .declared_dependencies import DeclaredDependencies
from .import_provider import import_providers
from .named_sources import named_sources
from .undeclared_imports import ImportDependencies

if TYPE_CHECKING:
    from .fetched_repositories import FetchedRepositories
    from .optional_parts import OptionalParts

FOR_DEMOS = regex(r"turtlesim|demo_nodes_\w+")
"""Packages that no one installs a robot for."""
OF_VARIABLES = regex(r"_(?:dir|path|pkg|package|share)$")
"""What is put behind a package's name to call the variable that holds it, or its folder."""
STARTER = "ros2launch"


@dataclass(frozen=True)
class LaunchDependencies:
    """The launch files of a package, and what it declares."""

    declared: DeclaredDependencies
    files: PackageFiles
    launch_files: Annotated[tuple[LaunchFile, ...], READABLE]
    cmake: CMake | None
    table: InstallTable | None
    python: PackageImports
    left: LeftFiles

    def role(self, path: str) -> Role:
        """Return the role of a launch file; `aside` if it is in no launch folder and not installed."""
        role = role_of(path)
        if path in self.test_files or role == "test":
            return "test"
        if "launch" in path.split("/")[:-1] or self.table is None or not self.table.knows("share"):
            return "launch"
        return "launch" if path in {row.source for row in self.table.rows} else "aside"

    def is_example(self, path: str) -> bool:
        return is_example(path)

    def is_for_examples(self, name: str, uses: Iterable[PackageReference]) -> bool:
        """Return whether only examples need a package, or it is one of the demos of ROS."""
        return FOR_DEMOS.fullmatch(name) is not None or all(self.is_example(use.path) for use in uses)

    def is_left(self, uses: Iterable[PackageReference]) -> bool:
        """Return whether no launch comes to any place, or all are in files that nothing installs and no page names."""
        return all(self.is_idle(use) or self.left.has(use.path) for use in uses)

    def is_idle(self, use: PackageReference) -> bool:
        """Return whether a place is in a function that nothing calls, or under a condition that never holds."""
        return any(each.holds(use.span) for each in self.idle.get(use.path, ()))

    @cached_property
    def idle(self) -> dict[str, tuple[Span, ...]]:
        modules = {module for each in self.python.files for one in each.imports for module in (one.module, *one.names)}
        names = {module.rpartition(".")[2] for module in modules}
        found: dict[str, tuple[Span, ...]] = {}
        for file in self.launch_files:
            is_imported = self.is_imported(file) or stem_of(file.path) in names
            found[file.path] = tuple(idle_parts(file, is_imported=is_imported))
        return found

    @cached_property
    def test_files(self) -> frozenset[str]:
        """The launch files that CMake names for tests and for nothing else."""
        if self.cmake is None:
            return frozenset()
        paths = {file.path for file in self.launch_files}
        named = {testing: named_sources(self.cmake, paths, testing) for testing in (False, True)}
        return frozenset(named[True] - named[False])

    @property
    def known_names(self) -> frozenset[str]:
        """The packages of the workspace and those that are declared."""
        return self.declared.workspace.names | self.declared.names

    def is_written(self, use: PackageReference) -> bool:
        """Return whether the place of a use holds the name itself, so that it can be replaced."""
        return self.files.source(use.path).slice(use.span) == use.name

    def is_unknown_package(self, name: str) -> bool:
        """Return whether no package of that name is known."""
        workspace = self.declared.workspace
        return not workspace.is_available(name) and workspace.kind_of(name) not in (NameKind.PACKAGE, NameKind.KEY)

    def is_told(self, name: str) -> bool:
        """Return whether a README links to the repository of an unknown package, or a page or a script fetches it."""
        return self.is_unknown_package(name) and self.fetched.may_have(name)

    @cached_property
    def fetched(self) -> FetchedRepositories:
        from .fetched_repositories import FetchedRepositories  # most packages are known

        return FetchedRepositories(self.files, self.declared.workspace, self.declared.hidden)

    def why_left_out(self, name: str, paths: Iterable[str]) -> str:
        """Return that a page builds this package without a neighbour on purpose, by what the files are called that need
        it, or that a page or a comment calls another package optional; "" for others.
        """
        if self.declared.workspace.named(name) is None:
            return self.optional.why([name], dict.fromkeys(paths))
        from .partial_builds import LEFT_OUT, is_built_without  # most declare their neighbours

        own = self.declared.facts.name
        return LEFT_OUT if is_built_without(self.files, own, name, {*paths}) else ""

    @cached_property
    def optional(self) -> OptionalParts:
        from .optional_parts import OptionalParts  # most packages are declared

        return OptionalParts(self.files)

    def meant(self, name: str) -> str | None:
        """Return the known package that an unknown name is a slip of; with another first letter it is another name.

        Another word makes another package: one of the same vendor, which is not here. A variable's `_dir` makes none.
        """
        if not self.is_unknown_package(name) or self.declared.workspace.is_listed(name):
            return None
        if self.declared.hidden.folder_of(name) or self.fetched.has_cloned(name):
            return None
        if self.cmake is not None and name == self.cmake.project_name:
            return self.declared.facts.name
        near = nearest(name, self.known_names)
        is_same = near is not None and (is_misspelt(name, near) or OF_VARIABLES.sub("", name) == near)
        is_meant = near is not None and is_same and begins_alike(name, near)
        return near if is_meant else self.having_what_is_started(name)

    def having_what_is_started(self, name: str) -> str | None:
        """Return the one package of the workspace that installs all that launch files start of an unknown one."""
        programs = (found for file in self.launch_files for found in file.programs())
        started = {executable.literal or "" for package, executable, _ in programs if package == name}
        having = [each.name for each in self.declared.workspace.packages if started <= each.executables]
        return having[0] if started and len(having) == 1 else None

    def missing(self, *, tests: bool) -> dict[str, list[PackageReference]]:
        """Return each package that is needed and not declared, with the places that need it."""
        if not self.declared.is_checked:
            return {}
        there = implied_by(self.declared.names, IN_TESTS if tests else IN_LAUNCH_FILES)
        there |= there_to_launch(self.declared) - (frozenset() if tests else LAUNCH)
        if tests:
            there |= self.missing(tests=False).keys()  # an exec_depend covers the tests
        found: dict[str, list[PackageReference]] = {}
        for use in self.uses(tests=tests):
            is_told = use.fails == "controller" and use.name in self.configured
            if self.declared.has_to_run(use.name) or use.name in there or is_told:
                continue
            if use.name not in LAUNCH or not self.is_brought(use.name, tests=tests):
                found.setdefault(use.name, []).append(use)
        return found

    @cached_property
    def configured(self) -> frozenset[str]:
        """What parameters and robots name plugins of, which DEP106 tells."""
        return frozenset(use.name.partition("/")[0] for use in self.declared.facts.plugin_uses)

    def is_brought(self, name: str, *, tests: bool) -> bool:
        """Return whether a declared dependency certainly brings a package."""
        bringer = self.declared.bringer([name], runs=not tests)
        return bringer is not None and bringer.is_certain

    def asked_for(self, *, tests: bool) -> dict[str, list[PackageReference]]:
        """Return what is missing, but for what modules import undeclared: one line is asked for once (DEP101)."""
        imported = ImportDependencies(self.declared, self.python, self.files).undeclared("run").keys() - LAUNCH
        return {name: uses for name, uses in self.missing(tests=tests).items() if tests or name not in imported}

    def nodes_in_code(self, *, tests: bool = False) -> dict[str, list[PackageReference]]:
        """Return the undeclared packages that only code describes nodes of, with the places: of tests, or installed.

        Installed code generates launch files for other packages, which may declare what they start.
        """
        found: dict[str, list[PackageReference]] = {}
        roles = ("test",) if tests else ("run", "launch")
        if self.declared.is_checked:
            there = implied_by(self.declared.names, IN_LAUNCH_FILES) | self.missing(tests=False).keys()
            if tests:
                there |= self.missing(tests=True).keys() | self.nodes_in_code().keys()
            known = (file for file in self.launch_files if file.nodes or (file.is_complete and file.has_entry_point))
            launches = {file.path for file in known}
            for file in self.python.files:
                for node in file.nodes if file.role in roles and file.path not in launches else ():
                    if NAME.fullmatch(node.package) and not self.declared.has([node.package]):
                        use = PackageReference(node.package, file.path, node.span, "describes a node of")
                        found.setdefault(node.package, []).append(use)
            there |= {name for name in found if tests and self.is_unknown_package(name)}  # made up, often
            found = {name: uses for name, uses in found.items() if name not in there}
        return found

    def uses(self, *, tests: bool) -> tuple[PackageReference, ...]:
        """Return what launch files need: those of tests, or the others."""
        return self._uses_in_tests if tests else self._uses

    @cached_property
    def _uses_in_tests(self) -> tuple[PackageReference, ...]:
        return tuple(
            use for file in self.launch_files if self.role(file.path) == "test" for use in with_conditions(file)
        )

    @cached_property
    def _uses(self) -> tuple[PackageReference, ...]:
        return tuple(
            use
            for file in self.launch_files
            if self.role(file.path) == "launch"
            for use in (*with_conditions(file), *self.import_uses(file), *self.reader_uses(file))
        )

    def reader_uses(self, file: LaunchFile) -> Iterator[PackageReference]:
        """Yield the package that reads a launch file in XML or YAML, where package.xml declares launch part by part."""
        if file.root is not None and not file.is_ros1 and file.nodes and not self.declared.names.isdisjoint(LAUNCH):
            at = file.root.name_span
            yield PackageReference(f"launch_{file.frontend}", file.path, at, "is read by")

    def is_imported(self, file: LaunchFile) -> bool:
        """Return whether another launch file imports a helper that is no launch file itself."""
        stem = stem_of(file.path)
        others = (each for other in self.launch_files if other is not file for each in other.imports)
        return any(stem in (each.module.rpartition(".")[2], *each.names) for each in others)

    def import_uses(self, file: LaunchFile) -> Iterator[PackageReference]:
        """Yield what a Python launch file imports, by the declared provider or by the one to declare.

        The imports of a launch file among the Python modules are DEP101's.
        """
        is_launched = file.has_entry_point and not is_program(file)
        if role_of(file.path) == "run" or (not is_launched and not self.is_imported(file)):
            return
        own = own_modules(self.files)
        for each in file.imports:
            if each.level or each.is_optional or each.is_for_typing or own.has(each.module, file.path):
                continue
            names = import_providers(self.declared, each)
            declared = next((name for name in names if name in self.declared.names), None)
            if declared or not any(may_serve(name, each.module) for name in self.declared.names):
                for name in (declared,) if declared else names[:1]:
                    does = "imports" if name == each.module.partition(".")[0] else f"imports `{each.module}` of"
                    yield PackageReference(name, file.path, each.span, does, fails="import")


def stem_of(path: str) -> str:
    return path.rpartition("/")[2].removesuffix(".py")


def with_conditions(file: LaunchFile) -> Iterator[PackageReference]:
    """Yield what a launch file needs, each with the argument that it takes where that is off by default.

    What is built and never added to the launch description is not visited: it needs nothing.
    """
    off = tuple(with_values(file.python, off_by_default(file)))
    idle = tuple(never_shown(file.python)) if file.python is not None else ()
    for use in package_references(file):
        if use.is_late and any(each.contains(use.span) for each in idle):
            continue
        inside = (part.argument for part in off if part.span.holds(use.span) and (use.is_late or part.is_branch))
        yield replace(use, only_with=next(inside, ""))


class ThereToLaunch:
    """What is there wherever a launch file is launched, the same for all packages of a workspace."""

    names: frozenset[str] = frozenset()

    def of(self, workspace: Workspace) -> frozenset[str]:
        """Return `ros2launch`, and all that comes with it."""
        self.names = self.names or frozenset({STARTER, *brought_by([STARTER], workspace)})
        return self.names


def there_to_launch(declared: DeclaredDependencies) -> frozenset[str]:
    return declared.workspace.index_of(ThereToLaunch).of(declared.workspace)
