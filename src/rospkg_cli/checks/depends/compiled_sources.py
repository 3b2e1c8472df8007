"""Which C++ files of a package are compiled, or installed for others to include."""

from __future__ import annotations

import posixpath
from collections.abc import Collection, Iterable, Iterator, Mapping

from ...languages.cmake.evaluated_command import EvaluatedCommand, path_in_package
from ...languages.cpp.file import CppFile, IncludeDirective
from ...lazy_regex import regex
from ...package.cmake.cmake_project import CMake
from ...package.cmake.foreign_commands import foreign_commands
from ...package.file_role import Role, role_of
from ..cmake.switched_off import SwitchedOff
from ..fault import Level
from .unadded_folders import files_nothing_adds

HEADERS = (".hpp", ".h", ".hh", ".hxx", ".ipp", ".tpp", ".inl", ".cuh")

LISTING = frozenset(
    {"add_executable", "add_library", "file", "install", "list", "set", "source_group", "target_sources"}
)

OBJECTS = regex(r"\$<TARGET_OBJECTS:[\w.+:-]+>")
"""What another target compiles."""


class SourcesByUse:
    """Which files of a package its build compiles; kept with its CMake, as several rules ask for each answer."""

    def __init__(self, cmake: CMake, files: Mapping[str, CppFile]) -> None:
        self.paths = tuple(files)
        self.is_known = are_sources_known(cmake)
        including = Inclusions(files)
        named = {testing: named_sources(cmake, files, testing) for testing in (False, True)}
        self.own = including.reached(named[False])
        off = SwitchedOff(cmake)
        on = (named_sources(cmake, files, testing, off=off) for testing in (False, True))
        self.likely = including.reached(set().union(*on))
        self.certain = including.reached(named_sources(cmake, files, False, maybe=False))
        self.including = including
        self.headers = {path for path in files if path.endswith(HEADERS) and not cmake.only_tests}
        public = {path for path in self.headers if "include/" in path}
        self.run = including.reached(named[False] | public)
        self.tests = including.reached(named[True]) - self.run
        asked = not any(call.texts[::2][:2] == ("BUILD_TESTING", "OFF") for call in cmake.named("option"))
        self.certain_tests = including.reached(named_sources(cmake, files, True, maybe=False)) if asked else set[str]()
        self.only_tests = cmake.only_tests
        self._unadded: frozenset[str] | None = None
        self._handed_out: set[str] | None = None

    def unadded(self, cmake: CMake) -> frozenset[str]:
        """Return the files below a CMakeLists.txt that nothing adds, where it is not known which files are compiled."""
        if self._unadded is None:
            is_open = self.is_known or cmake.includes_unknown_files
            found = frozenset[str]() if is_open else files_nothing_adds(cmake.package_files, cmake, self.paths)
            self._unadded = found - self.run - self.tests
        return self._unadded

    def is_left(self, cmake: CMake, path: str) -> bool:
        """Return whether no target compiles a file, nor one that includes it, and nobody gets it.

        Where a package compiles nothing, its build may be forgotten: only a file is left that it has in a comment.
        """
        if not self.is_known:
            return path in self.unadded(cmake)
        if not (self.own or self.tests or is_named(cmake, path)):
            return False
        if path in self.headers - self.own - self.tests:
            return path not in self.handed_out(cmake)
        if path in self.run | self.tests or path not in self.paths:
            return False
        return self.role(path) is None or not may_be_handed_out(cmake, path)

    def handed_out(self, cmake: CMake) -> set[str]:
        """Return the headers that may be installed, and what these include."""
        if self._handed_out is None:
            self._handed_out = self.including.reached(each for each in self.headers if may_be_handed_out(cmake, each))
        return self._handed_out

    def role(self, path: str) -> Role | None:
        """Return the role of a file that is compiled, or installed for others; None for any other."""
        if not self.is_known:
            return "test" if self.only_tests else as_built(role_of(path))
        if path in self.tests:
            return "test"
        built = as_built(role_of(path))
        is_header = path.endswith(HEADERS) and built == "run" and bool(self.run or not self.tests)
        return built if path in self.run or is_header else None


def sources_by_use(cmake: CMake, sources: Iterable[CppFile]) -> tuple[SourcesByUse, Mapping[str, CppFile]]:
    files = {source.path: source for source in sources}
    known: SourcesByUse | None = vars(cmake).get("sources_by_use")
    if known is None or known.paths != tuple(files):
        known = vars(cmake)["sources_by_use"] = SourcesByUse(cmake, files)
    return known, files


def compiled_sources(cmake: CMake, sources: Iterable[CppFile]) -> list[tuple[CppFile, Role]]:
    """Return the sources of targets, installed headers, and the files of the package that they include, with roles.

    Files that only tests use have the role `test`. All files are returned where the sources of a target are unknown.
    Those come last that nothing compiles or gets.
    """
    known, files = sources_by_use(cmake, sources)
    found = [(source, role) for path, source in files.items() if (role := known.role(path)) is not None]
    return sorted(found, key=lambda each: known.is_left(cmake, each[0].path))


def own_compiled(cmake: CMake, sources: Iterable[CppFile]) -> set[str] | None:
    """Return the files that the package's own build opens, without headers that only others do; None where unknown."""
    known, _ = sources_by_use(cmake, sources)
    return known.own if known.is_known else None


def harm_in(cmake: CMake, sources: Iterable[CppFile], path: str) -> Level:
    """Return how bad it is that a file can't be compiled: an error where the package's own build certainly does it.

    What is compiled on demand, for tests, or by others alone is a warning, a leftover beside what is compiled an info,
    and so is what only a switch that is off or a target that nobody asks for has.
    Where nothing is compiled, or it is not known what is, so is a header that is not handed out, and a source of which
    no CMake file has the name.
    """
    known, _ = sources_by_use(cmake, sources)
    if path in known.own | known.tests:
        if known.is_known and path not in known.likely:
            return "info"
        return "error" if known.is_known and path in known.certain else "warning"
    if known.is_known and known.own:
        return "info"
    is_met = may_be_handed_out(cmake, path) if path.endswith(HEADERS) else is_named(cmake, path)
    return "warning" if is_met else "info"


def may_be_handed_out(cmake: CMake, path: str) -> bool:
    """Return whether a header may be installed, so that another package gets it."""
    is_known = cmake.is_complete and cmake.ends_a_package and not cmake.includes_unknown_files
    is_automatic = any(call.name.endswith("ament_auto_package") for call in cmake.calls)
    if not is_known or is_automatic or next(foreign_commands(cmake), None) is not None:
        return True
    for rule in cmake.installs:
        if rule.kind == "CODE" or any("HEADER" in text or text == "FILE_SET" for text in rule.call.texts):
            return True
        paths = [path_in_package(word.text, rule.call.folder) if word.is_known else "" for word in rule.items]
        if rule.kind != "TARGETS" and any(f"{path}/".startswith(f"{each}/" if each else "") for each in held(paths)):
            return True
    return False


def held(paths: Iterable[str | None]) -> Iterator[str]:
    """Yield the paths that are in the package, without a slash or a dot at their ends."""
    return (posixpath.normpath(each).strip("./") for each in paths if each is not None)


def is_named(cmake: CMake, path: str) -> bool:
    """Return whether a CMake file has the name of a source, without its ending, in a comment too."""
    stem = posixpath.splitext(posixpath.basename(path))[0]
    return any(stem in file.source.text for file in cmake.files)


def compiled_on_demand(cmake: CMake, sources: Iterable[CppFile]) -> set[str]:
    """Return the files that are compiled under a condition alone, such as an option that is off by default."""
    known, _ = sources_by_use(cmake, sources)
    always = known.certain | known.certain_tests
    return (known.own | known.tests) - always


def certainly_compiled(cmake: CMake, sources: Iterable[CppFile]) -> set[str]:
    """Return the files that every build of the package opens, or that every run of its tests does."""
    known, _ = sources_by_use(cmake, sources)
    return known.certain | known.certain_tests


def as_built(role: Role) -> Role:
    return "run" if role == "launch" else role


def only_under_conditions(cmake: CMake, sources: Iterable[CppFile]) -> frozenset[str]:
    """Return the files that others of the package include, and the preprocessor may never open: each way has an `#if`.

    It begins at the files that no other includes; what no target compiles, as far as that is known, includes none.
    """
    files = {source.path: source for source in sources}
    known, _ = sources_by_use(cmake, files.values())
    if known.is_known and known.own:
        files = {path: file for path, file in files.items() if path in known.run | known.tests}
    by_name = paths_by_name(files)
    certain: dict[str, set[str]] = {path: set() for path in files}
    included = set[str]()
    for path, source in files.items():
        for each in source.includes:
            meant = {other for other in included_paths(each.path, by_name) if other != path}
            included |= meant
            certain[path] |= set() if each.is_conditional else meant
    opened, waiting = set[str](), sorted(files.keys() - included)
    while waiting:
        path = waiting.pop()
        if path not in opened:
            opened.add(path)
            waiting += certain[path]
    return frozenset(included - opened)


def paths_by_name(files: Iterable[str]) -> Mapping[str, list[str]]:
    found: dict[str, list[str]] = {}
    for path in files:
        found.setdefault(path.rpartition("/")[2], []).append(path)
    return found


def included_paths(header: str, by_name: Mapping[str, list[str]]) -> Iterator[str]:
    """Yield the files of the package that an include may mean."""
    if (known := by_name.get(header.rpartition("/")[2])) is not None:
        wanted = "/" + posixpath.normpath(header).lstrip("./")
        yield from (path for path in known if f"/{path}".endswith(wanted))


class Inclusions:
    """Which files of a package include which."""

    def __init__(
        self, files: Mapping[str, CppFile], *, only_certain: bool = False, unconditional: bool = False
    ) -> None:
        self.files = files
        self.only_certain = only_certain
        """Whether an include that may mean one of several files counts as none."""
        self.unconditional = unconditional
        """Whether an include inside of `#if` counts as none."""
        self.by_name = paths_by_name(files)
        self.known: dict[str, list[str]] = {}

    def included_by(self, path: str) -> list[str]:
        """Return the files of the package that one includes, wherever they lie."""
        if path not in self.known:
            counted = (each for each in self.files[path].includes if not (self.unconditional and each.is_conditional))
            self.known[path] = [other for each in counted for other in self.meant(path, each)]
        return self.known[path]

    def meant(self, path: str, each: IncludeDirective) -> list[str]:
        """Return the files that an include may mean: in quotes the one beside the file, where there is one."""
        beside = posixpath.normpath(posixpath.join(posixpath.dirname(path), each.path))
        is_beside = beside in self.files and not each.is_angled
        found = [beside] if is_beside else list(included_paths(each.path, self.by_name))
        return [] if self.only_certain and len(found) > 1 else found

    def reached(self, first: Iterable[str]) -> set[str]:
        """Return some files, and those of the package that they include, and so on."""
        found: set[str] = set()
        waiting = list(first)
        while waiting:
            path = waiting.pop()
            if path not in found:
                found.add(path)
                waiting += self.included_by(path)
        return found


def named_sources(
    cmake: CMake, files: Collection[str], testing: bool, *, maybe: bool = True, off: SwitchedOff | None = None
) -> set[str]:
    """Return the files that any command names: one that is run for tests alone, or one that always is.

    Those that are `off`, which nobody here asks for, are left out. Without `maybe`, commands and words
    under a condition that may not hold are left out, and commands that compile nothing by themselves. A header among
    the sources of a target is left out: the compiler opens it where a source includes it, but for Qt's moc, which reads
    what is listed.
    """
    bases: set[str] = set()
    has_moc = any("AUTOMOC" in text for call in cmake.calls for text in call.texts)
    for target in cmake.targets:
        base = path_in_package(target.folder.text, target.call.folder) if target.folder is not None else None
        if base is not None and target.call.testing is testing and (maybe or not target.call.maybe):
            bases.add(f"{base}/")
    found = {path for path in files if path.startswith(tuple(bases))} if bases else set()
    for call in cmake.calls:
        is_left = off is not None and (is_idle(call) or off.has(call))
        if call.testing is testing and not is_left and (maybe or not (call.maybe or is_idle(call))):
            paths = (path_in_package(word.text, call.folder) for word in call.words if maybe or not word.maybe)
            idle = () if has_moc or not lists_headers(call) else HEADERS
            found |= {path for path in paths if path is not None and path in files and not path.endswith(idle)}
    return found


def lists_headers(call: EvaluatedCommand) -> bool:
    """Return whether a command may be given headers for an editor's sake, or to copy them, and opens none itself."""
    return call.name in LISTING or call.name.startswith(("ament_add_", "ament_auto_add_"))


def is_idle(call: EvaluatedCommand) -> bool:
    """Return whether a command compiles none of the files that it names unless somebody asks for that."""
    return call.name == "install" or "EXCLUDE_FROM_ALL" in call.texts


def are_sources_known(cmake: CMake) -> bool:
    """Return whether the sources of every target are known."""
    folders = (path_in_package(t.folder.text, t.call.folder) for t in cmake.targets if t.folder is not None)
    words = (word for target in cmake.targets for word in target.sources if not OBJECTS.fullmatch(word.text))
    return cmake.is_complete and all(word.is_known for word in words) and None not in folders
