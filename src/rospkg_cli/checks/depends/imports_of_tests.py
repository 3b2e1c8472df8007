"""What only the tests of a package import, and package.xml does not declare (DEP102)."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cached_property

from ...light_dataclasses import dataclass
from ...ros.implied_dependencies import IN_TESTS, implied_by
from ..python.unrun_tests import is_never_run
from .brought_dependencies import COLCON, ROSDEP, Bringer
from .declared_dependencies import DeclaredDependencies
from .import_use import ImportUse, UndeclaredImport
from .undeclared_imports import ImportDependencies

RUNNERS = frozenset({"python3-pytest", "launch_ros", "launch_testing", "ament_index_python"})
"""What runs the tests, and finds files for them: it is fine if it comes with a declared dependency."""


@dataclass(frozen=True)
class ImportsOfTests:
    imports: ImportDependencies

    @property
    def declared(self) -> DeclaredDependencies:
        return self.imports.declared

    def missing(self) -> list[UndeclaredImport]:
        """Return what only tests import undeclared, without what comes with other undeclared names."""
        installed = self.imports.undeclared("run")
        found = {name: p for name, p in self.imports.undeclared("test").items() if name not in installed}
        result = []
        for name, places in found.items():
            found_with = self.bringer(name)
            is_tool = found_with is not None and found_with.name in (COLCON, ROSDEP)
            if (found_with is None or is_tool) and name in implied_by(found.keys() - {name}, IN_TESTS):
                continue
            if found_with:
                is_fine = name in RUNNERS and found_with.is_certain and not is_tool
                result += [] if is_fine else [UndeclaredImport(name, tuple(places), (), found_with)]
            else:
                brings = sorted(implied_by([name], IN_TESTS) & found.keys())
                result.append(UndeclaredImport(name, tuple(places), tuple(brings)))
        return result

    def bringer(self, name: str) -> Bringer | None:
        """Return the declared dependency that brings a package for the tests, or may bring it; None for none."""
        implying = (Bringer(each) for each in sorted(self.declared.names) if name in implied_by([each], IN_TESTS))
        return next(implying, None) or self.declared.bringer([name], runs=False)

    @cached_property
    def has_pytest(self) -> bool:
        """Whether `colcon test` may run pytest: for ament_python, only where setup.py or setup.cfg names it.

        Elsewhere colcon-core (from 0.6 on) runs unittest, which finds no test that is a plain function.
        """
        asked = (
            self.imports.files.readable_text(path)
            for path in ("setup.py", "setup.cfg")
            if self.imports.files.exists(path)
        )
        return self.declared.facts.build_type != "ament_python" or any("pytest" in text for text in asked)

    def are_never_run(self, places: Iterable[ImportUse]) -> bool:
        """Return whether all places are in tests that `colcon test` does not run."""
        build_type = self.declared.facts.build_type
        return all(
            is_never_run(path, self.imports.files, self.imports.cmake, build_type)
            for path in {each.path for each in places}
        )
