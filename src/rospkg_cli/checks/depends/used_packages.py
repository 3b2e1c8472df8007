"""What in a package may use another one: its imports, its includes, and words in any of its files."""

from __future__ import annotations

from functools import cached_property

from ...files import PackageFiles
from ...languages.cpp.file import CppFile
from ...languages.python.imports import Import
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.python.python_imports import PackageImports
from ...ros.headers import SHARED
from ...ros.imports import may_serve
from .build_tools_of_cmake import ENVIRONMENT
from .declared_dependencies import DeclaredDependencies
from .import_provider import import_providers
from .word_index import WordIndex

BY_GENERATORS = frozenset({"action_msgs", "service_msgs", "builtin_interfaces", "unique_identifier_msgs"})
"""Packages that the generated code of interfaces uses."""


@dataclass(frozen=True)
class UsedPackages:
    declared: DeclaredDependencies
    python: PackageImports
    files: PackageFiles
    cmake: CMake | None
    sources: tuple[CppFile, ...]

    @cached_property
    def words(self) -> WordIndex:
        """The words of all files, by what the files are for: build, run, test, docs."""
        return WordIndex(self.files, self.declared.manifest, self.cmake)

    def may_use(self, name: str) -> bool:
        """Return whether anything in the package may use another one."""
        return self.is_imported(name) or self.words.has(name) or self.is_built_with(name)

    def is_tool_used(self, name: str) -> bool:
        """Return whether tests import a tool, or launch_testing, which comes with others of its family."""
        return self.is_imported(name) or (name.startswith("launch_testing") and self.is_imported("launch_testing"))

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
        """Return whether an included header may be of a package, by its place in the workspace or its shared folder."""
        for header in {each.path for source in self.sources for each in source.includes}:
            owners, folder = self.declared.workspace.with_header(header), header.partition("/")[0]
            if name in owners or (not owners and folder in SHARED and name.startswith(folder)):
                return True
        return False

    def is_imported(self, name: str) -> bool:
        """Return whether an import may be of a package; `tf2_ros_py` has the module `tf2_ros`, so `_py` is ignored."""
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
