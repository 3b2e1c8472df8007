"""Dependencies that only tests use and package.xml declares for more (DEP204)."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...light_dataclasses import dataclass
from ...package.dependency import Dependency
from ...ros.implied_dependencies import LAUNCH
from ...ros.imports import may_serve
from .unused_dependencies import BUILT_IN, TOOLS, UnusedDependencies

TEST_TOOLS = TOOLS | {"python3-pytest", "ament_cmake_gtest", "ament_cmake_gmock", "ament_cmake_pytest"}


@dataclass(frozen=True)
class TestOnlyDependencies:
    unused: UnusedDependencies

    def dependencies(self) -> Iterator[Dependency]:
        """Yield the dependencies that tests alone import, include or look for.

        An exec_depend counts only where nothing but tests can use it: another may be a node that is started by name.
        """
        declared = self.unused.declared
        python = declared.facts.build_type == "ament_python"
        cmake = self.unused.used.cmake
        is_known = (
            self.unused.used.python.is_complete if python else cmake is not None and self.unused.is_complete(cmake)
        )
        for each in declared.manifest.dependencies if declared.is_checked and is_known else ():
            tagged = each.tag in BUILT_IN or (each.tag == "exec_depend" and (python or each.name in TEST_TOOLS))
            if tagged and self.is_tested_with(each.name) and not self.is_used(each.name):
                yield each

    def is_tested_with(self, name: str) -> bool:
        cmake = self.unused.used.cmake
        found = any(each.name == name and each.call.testing for each in cmake.packages) if cmake else False
        return found or name in self.import_providers[True]

    def is_used(self, name: str) -> bool:
        """Return whether anything else may use it; launch files in XML and YAML name nothing that reads them."""
        if name in LAUNCH:
            return True
        files = [file for file in self.unused.used.python.files if file.role != "test"]
        modules = {each.module for file in files for each in file.imports}
        alike = name.removesuffix("_py") in {module.partition(".")[0] for module in modules}
        served = name in self.import_providers[False] or alike or any(may_serve(name, module) for module in modules)
        return served or self.unused.used.words.has(name, "run", "docs") or self.unused.used.is_built_with(name)

    @cached_property
    def import_providers(self) -> dict[bool, frozenset[str]]:
        """The providers of the imports of tests (True), and of everything else (False)."""
        found: dict[bool, set[str]] = {True: set(), False: set()}
        for file in self.unused.used.python.files:
            for each in file.imports:
                found[file.role == "test"].update(self.unused.used.providers_of(each))
        return {testing: frozenset(names) for testing, names in found.items()}
