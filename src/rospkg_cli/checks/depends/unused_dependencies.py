"""Dependencies that package.xml declares and nothing in the package uses (DEP202)."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...files import PackageFiles
from ...languages.cpp.file import CppFile
from ...languages.python.imports import Import
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.dependency import Dependency
from ...package.python.python_imports import PackageImports
from ...ros.headers import SHARED
from ...ros.imports import may_serve
from ...ros.names import NameKind
from .build_tools_of_cmake import ENVIRONMENT
from .declared_dependencies import DeclaredDependencies
from .import_provider import import_providers
from .missing_find_package import AUTOMATIC
from .named_uses import NamedUses
from .word_index import WordIndex

BUILT_IN = frozenset({"depend", "build_depend"})
"""Tags that say "something here is made with it"; in a Python package that is an import."""

IMPORTED_ONLY = regex(r".*_(msgs|srvs|interfaces|actions)")
"""Packages that nothing but an import uses; another exec_depend may be there for a node started by name."""

LATER = frozenset({"exec_depend", "test_depend"})

BY_GENERATORS = frozenset({"action_msgs", "service_msgs", "builtin_interfaces", "unique_identifier_msgs"})
"""What the code that is made of interfaces uses."""

TOOLS = frozenset({"launch", "launch_ros", "launch_testing", "launch_testing_ament_cmake", "launch_testing_ros"})
"""What tests that are written with them name."""


@dataclass(frozen=True, slots=True)
class UnusedDependency:
    dependency: Dependency
    is_run_only: bool = False
    """Whether something names it that is not built: then exec_depend is enough."""


@dataclass(frozen=True)
class UnusedDependencies:
    """What package.xml declares, and everything in the package that may use it."""

    declared: DeclaredDependencies
    python: PackageImports
    files: PackageFiles
    cmake: CMake | None
    sources: tuple[CppFile, ...]

    @cached_property
    def words(self) -> WordIndex:
        return WordIndex(self.files, self.declared.manifest, self.cmake)

    def dependencies(self) -> Iterator[UnusedDependency]:
        """Yield the dependencies that nothing uses, or nothing that is built."""
        if self.declared.facts.build_type == "ament_python":
            yield from self.in_python_package()
        elif self.cmake is not None and self.declared.is_checked and self.is_complete(self.cmake):
            yield from self.in_cmake_package()

    def in_python_package(self) -> Iterator[UnusedDependency]:
        """Yield the dependencies that are there for an import and that nothing imports or names.

        Only where all of the Python could be read, and only where there is some: a package without code gathers
        dependencies on purpose.
        """
        code = [file for file in self.python.files if not file.path.endswith(("setup.py", "__init__.py"))]
        if not self.python.is_complete or not code:
            return
        for dependency in self.declared.manifest.dependencies:
            for_import = dependency.tag == "exec_depend" and self.is_for_import(dependency.name)
            used = self.is_imported(dependency.name) or self.words.has(dependency.name)
            if (dependency.tag in BUILT_IN or for_import) and not used:
                yield UnusedDependency(dependency)

    def is_for_import(self, name: str) -> bool:
        """Return whether nothing but an import can use a package: interfaces, or a Python library of Debian's."""
        return IMPORTED_ONLY.fullmatch(name) is not None or (name.startswith("python") and "-" in name)

    def in_cmake_package(self) -> Iterator[UnusedDependency]:
        """Yield the ROS packages that are declared for the build, as tools for tests or as interfaces, without a trace.

        A trace in documents or tests shows that a package is intended, and not that it is needed for the build.
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
                yield from () if self.is_tool_used(name) or self.words.has(name) else (UnusedDependency(dependency),)
            elif tag in LATER and self.has_code and self.leaves_no_trace(name):
                yield UnusedDependency(dependency)

    def leaves_no_trace(self, name: str) -> bool:
        """Return whether a package is of a kind that is always named where it is used, and nothing names it."""
        if IMPORTED_ONLY.fullmatch(name):
            return name not in BY_GENERATORS and not self.may_use(name)
        return NamedUses(self.words, self.declared.workspace).is_unused(name)

    def for_the_build(self, dependency: Dependency) -> Iterator[UnusedDependency]:
        """Yield a dependency that is declared for the build, where nothing that is built uses it.

        One for the build alone that is imported is told by DEP201.
        """
        name = dependency.name
        if self.is_built_with(name):
            return
        is_tested = self.words.has(name, "test")
        runs = self.words.has(name, "run") or (self.is_imported(name) and not is_tested)
        if runs and not self.runs_already(name) and not (dependency.tag == "build_depend" and self.is_imported(name)):
            yield UnusedDependency(dependency, is_run_only=True)
        elif not runs and not is_tested:
            is_meant = self.words.has(name, "docs") or not self.has_code
            if not is_meant or (dependency.tag == "depend" and not self.may_find_by_manifest):
                yield UnusedDependency(dependency, is_run_only=is_meant)

    def may_use(self, name: str) -> bool:
        """Return whether anything in the package may use another one."""
        return self.is_imported(name) or self.words.has(name) or self.is_built_with(name)

    @property
    def may_find_by_manifest(self) -> bool:
        """Whether CMake may find what package.xml declares for the build, by a command that reads it."""
        return self.cmake is not None and any(AUTOMATIC.fullmatch(call.name) for call in self.cmake.calls)

    def is_tool_used(self, name: str) -> bool:
        """Return whether tests import a tool, or launch_testing, which comes with others of its family."""
        return self.is_imported(name) or (name.startswith("launch_testing") and self.is_imported("launch_testing"))

    @property
    def has_code(self) -> bool:
        """Return whether the package makes anything: one without code gathers dependencies on purpose."""
        return bool(self.cmake and self.cmake.targets) or bool(self.sources) or bool(self.declared.facts.modules)

    def runs_already(self, name: str) -> bool:
        """Return whether a package is declared for running under a tag of its own: it is needed for both."""
        return any(each.name == name and each.tag == "exec_depend" for each in self.declared.manifest.dependencies)

    def is_complete(self, cmake: CMake) -> bool:
        """Return whether all that CMake does is known."""
        return cmake.is_complete and not cmake.reads_unknown_files

    def is_built_with(self, name: str) -> bool:
        """Return whether something that is built may use a package.

        The headers of packages of the workspace are known; those of others are in folders of their names.
        """
        if self.words.has(name, "build") or (name in BY_GENERATORS and self.declared.facts.interfaces):
            return True
        if name == ENVIRONMENT and self.cmake is not None:
            return any("ENV{ROS_" in file.source.text for file in self.cmake.files)
        return self.has_header(name) or name.endswith(("_vendor", "_cmake"))

    def has_header(self, name: str) -> bool:
        """Return whether a package may have an included header; of shared folders the workspace knows what is whose."""
        for header in {each.path for source in self.sources for each in source.includes}:
            owners, folder = self.declared.workspace.with_header(header), header.partition("/")[0]
            if name in owners or (not owners and folder in SHARED and name.startswith(folder)):
                return True
        return False

    def is_imported(self, name: str) -> bool:
        """Return whether an import may use it; `tf2_ros_py` holds the module `tf2_ros`, so its `_py` doesn't count."""
        if name.removesuffix("_py") in {module.partition(".")[0] for module in self.modules}:
            return True
        return name in self.import_names or any(may_serve(name, module) for module in self.modules)

    @cached_property
    def modules(self) -> frozenset[str]:
        return frozenset(each.module for file in self.python.files for each in file.imports)

    @cached_property
    def import_names(self) -> frozenset[str]:
        """Every name that may provide an import."""
        imports = (each for file in self.python.files for each in file.imports)
        return frozenset(name for each in imports for name in self.providers_of(each))

    def providers_of(self, what: Import) -> tuple[str, ...]:
        return import_providers(self.declared, what)
