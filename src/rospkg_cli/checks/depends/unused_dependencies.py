"""Dependencies that package.xml declares and nothing in the package uses (DEP202)."""

from __future__ import annotations

from collections.abc import Iterator

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.dependency import Dependency
from ...ros.names import NameKind
from .declared_dependencies import DeclaredDependencies
from .missing_find_package import AUTOMATIC
from .named_uses import NamedUses
from .used_packages import BY_GENERATORS, UsedPackages

BUILT_IN = frozenset({"depend", "build_depend"})
"""Tags that say "something here is made with it"; in a Python package that is an import."""

IMPORTED_ONLY = regex(r".*_(msgs|srvs|interfaces|actions)")
"""Packages that nothing but an import uses; another exec_depend may be there for a node started by name."""

LATER = frozenset({"exec_depend", "test_depend"})

TOOLS = frozenset({"launch", "launch_ros", "launch_testing", "launch_testing_ament_cmake", "launch_testing_ros"})
"""Packages that the tests which use them always name."""


@dataclass(frozen=True, slots=True)
class UnusedDependency:
    dependency: Dependency
    is_run_only: bool = False
    """Whether something names it, but nothing that is built: exec_depend is enough."""


@dataclass(frozen=True)
class UnusedDependencies:
    """What package.xml declares, and everything in the package that may use it."""

    declared: DeclaredDependencies
    used: UsedPackages

    def dependencies(self) -> Iterator[UnusedDependency]:
        """Yield the dependencies that nothing uses, or nothing that is built."""
        if self.declared.facts.build_type == "ament_python":
            yield from self.in_python_package()
        elif self.used.cmake is not None and self.declared.is_checked and self.is_complete(self.used.cmake):
            yield from self.in_cmake_package()

    def in_python_package(self) -> Iterator[UnusedDependency]:
        """Yield the dependencies that are there for an import and that nothing imports or names.

        None where some Python could not be read, or where there is none: a package without code collects dependencies
        on purpose.
        """
        code = [file for file in self.used.python.files if not file.path.endswith(("setup.py", "__init__.py"))]
        if not self.used.python.is_complete or not code:
            return
        for dependency in self.declared.manifest.dependencies:
            for_import = dependency.tag == "exec_depend" and self.is_for_import(dependency.name)
            used = self.used.is_imported(dependency.name) or self.used.words.has(dependency.name)
            if (dependency.tag in BUILT_IN or for_import) and not used:
                yield UnusedDependency(dependency)

    def is_for_import(self, name: str) -> bool:
        """Return whether nothing but an import can use a package: interfaces, or a Python library of Debian's."""
        return IMPORTED_ONLY.fullmatch(name) is not None or (name.startswith("python") and "-" in name)

    def in_cmake_package(self) -> Iterator[UnusedDependency]:
        """Yield the ROS packages that are declared for the build, as tools for tests, or as interfaces, and not used.

        Being named in documents or tests shows that a package is intended, but not that the build needs it.
        """
        for dependency in self.declared.manifest.dependencies:
            name, tag = dependency.name, dependency.tag
            interfaces = IMPORTED_ONLY.fullmatch(name) is not None
            is_package = interfaces or self.declared.workspace.kind_of(name) is NameKind.PACKAGE
            if not is_package or name == self.declared.facts.name:
                continue
            if tag in BUILT_IN:
                yield from self.for_the_build(dependency)
            elif tag == "test_depend" and name in TOOLS:
                is_used = self.used.is_tool_used(name) or self.used.words.has(name)
                yield from () if is_used else (UnusedDependency(dependency),)
            elif tag in LATER and self.has_code and self.leaves_no_trace(name):
                yield UnusedDependency(dependency)

    def leaves_no_trace(self, name: str) -> bool:
        """Return whether a package is of a kind that its users always name, and nothing names it."""
        if IMPORTED_ONLY.fullmatch(name):
            return name not in BY_GENERATORS and not self.used.may_use(name)
        return NamedUses(self.used.words, self.declared.workspace).is_unused(name)

    def for_the_build(self, dependency: Dependency) -> Iterator[UnusedDependency]:
        """Yield a dependency that is declared for the build, where nothing that is built uses it.

        DEP201 reports a build_depend that is imported.
        """
        name = dependency.name
        if self.used.is_built_with(name):
            return
        is_tested = self.used.words.has(name, "test")
        runs = self.used.words.has(name, "run") or (self.used.is_imported(name) and not is_tested)
        is_wrong_kind = dependency.tag == "build_depend" and self.used.is_imported(name)
        if runs and not self.runs_already(name) and not is_wrong_kind:
            yield UnusedDependency(dependency, is_run_only=True)
        elif not runs and not is_tested:
            is_named = self.used.words.has(name, "docs") or not self.has_code
            if not is_named or (dependency.tag == "depend" and not self.may_find_by_manifest):
                yield UnusedDependency(dependency, is_run_only=is_named)

    @property
    def may_find_by_manifest(self) -> bool:
        """Whether CMake may find what package.xml declares for the build, by a command that reads it."""
        return self.used.cmake is not None and any(AUTOMATIC.fullmatch(call.name) for call in self.used.cmake.calls)

    @property
    def has_code(self) -> bool:
        """Whether the package has code: one without any collects dependencies on purpose."""
        return (
            bool(self.used.cmake and self.used.cmake.targets)
            or bool(self.used.sources)
            or bool(self.declared.facts.modules)
        )

    def runs_already(self, name: str) -> bool:
        """Return whether a package is declared for running under a tag of its own: it is needed for both."""
        return any(each.name == name and each.tag == "exec_depend" for each in self.declared.manifest.dependencies)

    def is_complete(self, cmake: CMake) -> bool:
        """Return whether all that CMake does is known."""
        return cmake.is_complete and not cmake.reads_unknown_files
