"""Commands that a module of CMake defines, called where nothing includes that module before."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake

MODULES = {
    "FindPkgConfig": ("pkg_check_modules", "pkg_search_module", "pkg_get_variable"),
    "ExternalProject": ("externalproject_add", "externalproject_add_step", "externalproject_get_property"),
    "FetchContent": ("fetchcontent_declare", "fetchcontent_makeavailable", "fetchcontent_populate"),
    "CheckCXXCompilerFlag": ("check_cxx_compiler_flag",),
    "CheckCCompilerFlag": ("check_c_compiler_flag",),
    "CheckCXXSourceCompiles": ("check_cxx_source_compiles",),
    "CheckIncludeFileCXX": ("check_include_file_cxx",),
    "CheckLanguage": ("check_language",),
    "CheckIPOSupported": ("check_ipo_supported",),
    "CMakeDependentOption": ("cmake_dependent_option",),
    "CMakePackageConfigHelpers": ("configure_package_config_file", "write_basic_package_version_file"),
    "GenerateExportHeader": ("generate_export_header",),
    "GoogleTest": ("gtest_discover_tests", "gtest_add_tests"),
}
"""The modules of CMake that a project itself includes, and commands that each of them defines."""
BY_FINDING = {"FindPkgConfig": ("PkgConfig",), "GoogleTest": ("GTest",)}
"""Packages that are found instead: their modules define the commands, or include the one that does."""
OWN = frozenset({"ament_cmake", "ament_lint_auto", "ament_lint_common"})
"""Packages that include none of these modules."""


@dataclass(frozen=True, slots=True)
class ModuleCommand:
    call: EvaluatedCommand
    module: str
    finds: str
    """What finds the command: a call of include() or find_package()."""
    is_certain: bool
    """Whether no package that is found can include the module."""


@dataclass(frozen=True)
class ModuleCommands:
    cmake: CMake

    def all(self) -> Iterator[ModuleCommand]:
        """Yield the first call for each module that nothing includes before."""
        if not self.cmake.is_complete or self.cmake.reads_unknown_files:
            return
        of_command = {name: module for module, names in MODULES.items() for name in names}
        seen: set[str] = set()
        for call in self.cmake.calls:
            seen.update(self.included_by(call))
            module = of_command.get(call.name)
            if module is None or module in seen or call.name in self.cmake.functions:
                continue
            seen.add(module)
            if not call.maybe and not self.is_named_elsewhere(module):
                finds = "find_package(PkgConfig REQUIRED)" if module == "FindPkgConfig" else f"include({module})"
                yield ModuleCommand(call, module, finds, self.finds_nothing_else)

    def included_by(self, call: EvaluatedCommand) -> Iterator[str]:
        """Yield the modules whose commands are known from a call on."""
        name = call.texts[0] if call.texts else ""
        if call.name == "include":
            yield name
        elif call.name == "find_package":
            yield from (module for module, names in BY_FINDING.items() if name in names)

    def is_named_elsewhere(self, module: str) -> bool:
        """Return whether a .cmake file of the package, as one that finds a package, has a word of a module."""
        words = (module, *BY_FINDING.get(module, ()))
        files = (path for path in self.cmake.package_files.paths if path.endswith(".cmake"))
        texts = (self.cmake.package_files.readable_text(path) for path in files)
        return any(word in text for text in texts for word in words)

    @cached_property
    def finds_nothing_else(self) -> bool:
        return all(each.name in OWN for each in self.cmake.packages)
