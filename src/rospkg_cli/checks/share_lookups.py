"""Rule input: the packages and files that Python modules and C++ look for in share directories."""

from __future__ import annotations

import ast
import posixpath
from collections.abc import Iterator

from ..files import PackageFiles
from ..languages.cpp.code_text import code_text
from ..languages.cpp.file import CppFile
from ..languages.cpp.unconditional import unconditional
from ..languages.python.branches import is_default
from ..languages.python.file import PythonFile
from ..languages.python.guarded_nodes import guarded_nodes, is_guarded
from ..languages.python.joined_paths import PathJoiner
from ..languages.python.nodes import last_name, nodes_of
from ..languages.python.unreached_places import is_unreached
from ..lazy_regex import regex
from ..light_dataclasses import dataclass
from ..package.cmake.cmake_project import CMake
from ..package.file_role import role_of
from ..package.install_table import InstallTable
from ..package.launch.file_references import is_file
from ..package.package_facts import PackageFacts
from ..package.python.share_paths import SHARE, share_of
from ..package.workspace import Workspace
from ..ros.names import NameKind
from ..source import Span
from ..suggest import near_names, nearest, slips
from .cpp.share_file_paths import share_file_paths
from .cpp.share_names import all_share_names
from .cpp.uncalled_members import is_in_uncalled
from .depends.compiled_sources import harm_in
from .install_faults import InstallFaults
from .paths.closest_path import closest_path
from .python.run_imports import RunImports
from .python.unrun_tests import is_never_run
from .python.wrong_calls import wrong_lookup
from .reached_modules import ReachedModules
from .reached_places import WHY, ReachedPlaces
from .unread_paths import UnreadPaths
from .unset_switches import UnsetSwitches

LOOKUPS = SHARE | {"get_package_prefix"}
CATCHES = frozenset({"PackageNotFoundError", "KeyError", "LookupError", "Exception", "BaseException"})
"""PackageNotFoundError is a KeyError."""

UNOPENED = frozenset({"OSError", "IOError", "EnvironmentError", "Exception", "BaseException"})
"""What is caught where a file may be missing; who names FileNotFoundError has thought of that."""
LOOKS_FIRST = frozenset(
    {"exists", "isfile", "is_file", "isdir", "is_dir", "FileNotFoundError", "makedirs", "mkdir", "create_director"}
)
WRITERS = regex(r"\b(?:to_csv|savetxt|savez?|dump|imwrite|writer?|ofstream)\b")
"""What writes a file of data: then one that is called like an output is no input."""
SHORTEST = len("nav2")
"""Of a package's name that is compared with all known ones."""


@dataclass(frozen=True, slots=True)
class UnknownShare:
    path: str
    span: Span
    """Of the package's name, between its quotes."""
    name: str
    near: str
    is_caught: bool = False
    """Whether code goes on without the package."""


@dataclass(frozen=True, slots=True)
class MissingShareFile:
    path: str
    span: Span
    package: str
    file: str
    """Relative to the share directory."""
    near: str | None
    is_here: bool
    """Whether the package has the file, and does not install it there."""
    goes_to: str | None = None
    """Where below the prefix it is installed instead."""


@dataclass(frozen=True)
class ShareLookups:
    run: RunImports
    files: PackageFiles
    facts: PackageFacts
    workspace: Workspace
    faults: InstallFaults
    sources: tuple[CppFile, ...] = ()
    cmake: CMake | None = None
    reached: ReachedModules | None = None
    table: InstallTable | None = None
    unread: UnreadPaths | None = None
    places: ReachedPlaces | None = None
    switches: UnsetSwitches | None = None

    def is_run(self, path: str) -> bool:
        """Return whether a file runs: every build compiles the C++; of Python see `is_left`."""
        return path.endswith(".py") or (self.cmake is not None and harm_in(self.cmake, self.sources, path) == "error")

    def is_uncompiled(self, path: str) -> bool:
        """Return whether no target compiles a file of C++, beside others that are compiled."""
        return self.cmake is not None and harm_in(self.cmake, self.sources, path) == "info"

    def is_left(self, path: str) -> bool:
        """Return whether a file is a module that nothing starts or imports, beside programs."""
        return path.endswith(".py") and self.reached is not None and self.reached.is_left(path)

    def is_never_run(self, path: str) -> bool:
        """Return whether a file is a test that `colcon test` does not run."""
        is_test = path.endswith(".py") and role_of(path) == "test"
        return is_test and is_never_run(path, self.files, self.cmake, self.facts.build_type)

    def why_seldom(self, path: str, span: Span) -> str:
        """Return what is said of a place that seldom or never runs; "" for others."""
        source = next((each for each in self.sources if each.path == path), None)
        if source is not None:
            why = WHY["never"] if is_in_uncalled(source, span, self.sources) else ""
        else:
            why = self.places.why_seldom(path, span) if self.places is not None else ""
        is_named = why not in ("", WHY["branch"])  # which switch it is says more than that there is a condition
        return why if is_named else self.why_off(path, span) or why

    def why_off(self, path: str, span: Span) -> str:
        """Return what is said of a place that only a switch leads to which nothing throws; "" for others."""
        return self.switches.why_off(path, span) if self.switches is not None else ""

    def is_conditional(self, path: str, span: Span) -> bool:
        """Return whether a place is in a branch of its function."""
        source = next((each for each in self.sources if each.path == path), None)
        if source is not None:
            return is_in_block(source, span) and not unconditional(source.source.text, [span.start])
        return self.places is not None and self.places.is_conditional(path, span)

    def is_softened(self, path: str, span: Span) -> bool:
        """Return whether a path in Python code is one of several: in a branch, for what nobody gives, or in a `try`."""
        file = self.run.modules.at(path) if path.endswith(".py") else None
        is_soft = file is not None and (is_default(file, span) or is_guarded(file, span, UNOPENED))
        return is_soft or self.is_conditional(path, span)

    @property
    def modules(self) -> Iterator[PythonFile]:
        """The files that run, but for launch files, which have rules of their own."""
        for file in self.run.running:
            if role_of(file.path) != "launch" and any(name in file.source.text for name in LOOKUPS):
                yield file

    def unknown_packages(self) -> Iterator[UnknownShare]:
        yield from self.unknown_in_cpp()
        for file in self.modules:
            caught = set(guarded_nodes(file.tree.body, CATCHES))
            for node in nodes_of(file.tree):
                if not isinstance(node, ast.Call) or last_name(node.func) not in LOOKUPS:
                    continue
                name, is_caught = literal_of(node), id(node) in caught
                near = self.meant(str(name.value), is_caught) if name is not None else None
                if name is not None and near and not is_unreached(file, file.span(name)):
                    whole = Span(file.span(name).start + 1, file.span(name).end - 1)
                    yield UnknownShare(file.path, whole, str(name.value), near, is_caught)

    def unknown_in_cpp(self) -> Iterator[UnknownShare]:
        for source in self.sources:
            for name, span, is_caught in all_share_names(source) if role_of(source.path) == "run" else ():
                if near := self.meant(name, is_caught):
                    yield UnknownShare(source.path, span, name, near, is_caught)

    def meant(self, name: str, is_caught: bool) -> str | None:
        """Return the package that is intended; where code goes on without it, the one that is here, of a clear slip."""
        near = self.near_package(name)
        here = (self.facts.name, *(each.name for each in self.workspace.packages))
        return near if near and not (is_caught and slips(name, here) != [near]) else None

    def near_package(self, name: str) -> str | None:
        """Return the package that is intended by the name of none; None where it is one, or near to none or several."""
        known = {*self.workspace.names, *(each.name for each in self.facts.dependencies), self.facts.name}
        is_own = name == self.facts.name.lower().replace("-", "_")  # what its name should be: XML101
        if is_own or name in known or self.workspace.is_available(name) or self.workspace.is_listed(name):
            return None
        if self.workspace.index.kind_of(name) is NameKind.PACKAGE or self.workspace.is_marked(name):
            return None
        if near := nearest(name, known):
            return near
        found = near_names(name, self.workspace.index.packages, 1) if len(name) > SHORTEST else []
        return found[0] if len(found) == 1 else None

    def missing_files(self) -> Iterator[MissingShareFile]:
        for file in self.modules:
            if looks_first(file):
                continue
            for found in PathJoiner(file, share_of).paths():
                path = posixpath.normpath(found.text.lstrip("/"))
                if found.text.startswith("/") and (facts := self.facts_of(found.base)) is not None:
                    missing = self.missing(file.path, file.span(found.node), facts, path)
                    if missing is not None and not is_unreached(file, missing.span):
                        yield missing
        for source in self.sources:
            if role_of(source.path) == "run" and not looks_first(source):
                for named in share_file_paths(source):
                    if (facts := self.facts_of(named.package)) is not None:
                        path = posixpath.normpath(named.file.lstrip("/"))
                        missing = self.missing(source.path, named.span, facts, path)
                        yield from [missing] if missing is not None else []

    def facts_of(self, name: str) -> PackageFacts | None:
        return self.facts if name == self.facts.name else self.workspace.named(name)

    def missing(self, where: str, span: Span, facts: PackageFacts, path: str) -> MissingShareFile | None:
        """Return a file that is not installed; None where it may be written, or where a rule of its folder tells it.

        A folder of the package counts as well, and so does a file that is called like one that is written and is here.
        """
        is_own = facts is self.facts
        is_here = is_own and (self.files.is_there(path) or path in self.files.folders)
        is_read = is_here and not WRITERS.search(self.files.readable_text(where))
        if not (is_read or is_file(path)) or not path.isprintable() or path.startswith(".."):
            return None
        if not facts.knows("share_files") or path in facts.share_files or facts.may_write(path):
            return None
        below = (*facts.share_files, *facts.uninstalled, *facts.run_time_files) if is_here else ()
        if path in facts.run_time_files or any(each.startswith(f"{path}/") for each in below):
            return None
        if path in facts.uninstalled and (not is_read or self.faults.is_told(facts.name, path)):
            return None
        near = None if is_here else closest_path(path, facts.share_files)
        if not is_here and (not near or (facts is self.facts and self.files.absent.is_expected(path))):
            return None
        goes_to = self.table.destination_of(path) if is_here and self.table is not None else None
        if goes_to and self.faults.is_told_at_its_destination(facts.name, goes_to):
            return None
        return MissingShareFile(where, span, facts.name, path, near, is_here, goes_to)


def literal_of(call: ast.Call) -> ast.Constant | None:
    """Return the package's name where a lookup is given a plain string, and not more than it takes."""
    if wrong_lookup(call):
        return None
    given = call.args[0] if call.args else next((each.value for each in call.keywords), None)
    plain = isinstance(given, ast.Constant) and isinstance(given.value, str) and given.value.isidentifier()
    return given if plain and isinstance(given, ast.Constant) else None


def is_in_block(source: CppFile, span: Span) -> bool:
    """Return whether a place is in braces: what stands outside of them runs at every start."""
    before = code_text(source.source.text[: span.start])
    return before.count("{") > before.count("}")


def looks_first(file: PythonFile | CppFile) -> bool:
    """Return whether code asks whether a file is there, makes its folder, or catches that it is not."""
    return any(name in file.source.text for name in LOOKS_FIRST)
