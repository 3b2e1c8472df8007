"""Rule input: code that looks for packages and files in share directories, and when it runs."""

from __future__ import annotations

from collections.abc import Iterator

from ..files import PackageFiles
from ..languages.cpp.code_text import code_text
from ..languages.cpp.file import CppFile
from ..languages.cpp.unconditional import unconditional
from ..languages.python.branches import is_default
from ..languages.python.file import PythonFile
from ..languages.python.guarded_nodes import is_guarded
from ..light_dataclasses import dataclass
from ..package.cmake.cmake_project import CMake
from ..package.file_role import role_of
from ..package.package_facts import PackageFacts
from ..source import Span
from .cpp.uncalled_members import is_in_uncalled
from .depends.compiled_sources import harm_in
from .missing_share_files import MissingShareFiles
from .python.run_imports import RunImports
from .python.unrun_tests import is_never_run
from .reached_modules import ReachedModules
from .reached_places import ReachedPlaces
from .share_lookup_calls import UNOPENED, looking_up
from .unknown_share_packages import UnknownSharePackages
from .unread_paths import UnreadPaths
from .unset_switches import UnsetSwitches
from .why_seldom import WHY


@dataclass(frozen=True)
class ShareLookups:
    run: RunImports
    files: PackageFiles
    facts: PackageFacts
    unknown: UnknownSharePackages
    missing: MissingShareFiles
    sources: tuple[CppFile, ...] = ()
    cmake: CMake | None = None
    reached: ReachedModules | None = None
    unread: UnreadPaths | None = None
    places: ReachedPlaces | None = None
    switches: UnsetSwitches | None = None

    def is_run(self, path: str) -> bool:
        """Return whether a file runs: every build compiles the C++; of Python see `is_left`."""
        return path.endswith(".py") or (self.cmake is not None and harm_in(self.cmake, self.sources, path) == "error")

    def is_uncompiled(self, path: str) -> bool:
        """Return whether no target compiles a file of C++, while others are compiled."""
        return self.cmake is not None and harm_in(self.cmake, self.sources, path) == "info"

    def is_left(self, path: str) -> bool:
        """Return whether a file is a module that nothing starts or imports."""
        return path.endswith(".py") and self.reached is not None and self.reached.is_left(path)

    def is_never_run(self, path: str) -> bool:
        """Return whether a file is a test that `colcon test` does not run."""
        is_test = path.endswith(".py") and role_of(path) == "test"
        return is_test and is_never_run(path, self.files, self.cmake, self.facts.build_type)

    def why_seldom(self, path: str, span: Span) -> str:
        """Return the end of a message that says why a place seldom or never runs; "" for others."""
        source = next((each for each in self.sources if each.path == path), None)
        if source is not None:
            why = WHY["never"] if is_in_uncalled(source, span, self.sources) else ""
        else:
            why = self.places.why_seldom(path, span) if self.places is not None else ""
        is_named = why not in ("", WHY["branch"])  # a named switch says more than that there is a condition
        return why if is_named else self.why_off(path, span) or why

    def why_off(self, path: str, span: Span) -> str:
        """Return the end of a message about a place that runs only with a switch that is off; "" for others."""
        return self.switches.why_off(path, span) if self.switches is not None else ""

    def is_conditional(self, path: str, span: Span) -> bool:
        """Return whether a place is in a branch of its function."""
        source = next((each for each in self.sources if each.path == path), None)
        if source is not None:
            return is_in_block(source, span) and not unconditional(source.source.text, [span.start])
        return self.places is not None and self.places.is_conditional(path, span)

    def is_softened(self, path: str, span: Span) -> bool:
        """Return whether a path in Python code is one of several: in a branch, as a default, or in a `try`."""
        file = self.run.modules.at(path) if path.endswith(".py") else None
        is_soft = file is not None and (is_default(file, span) or is_guarded(file, span, UNOPENED))
        return is_soft or self.is_conditional(path, span)

    @property
    def modules(self) -> Iterator[PythonFile]:
        """The Python files that look up packages, but for launch files."""
        return looking_up(self.run)


def is_in_block(source: CppFile, span: Span) -> bool:
    """Return whether a place is in braces; what is outside of them runs at every start."""
    before = code_text(source.source.text[: span.start])
    return before.count("{") > before.count("}")
