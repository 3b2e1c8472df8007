"""C++ includes of packages that package.xml does not declare (DEP105)."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable, Iterator
from functools import cached_property

from ...files import PackageFiles
from ...languages.cmake.evaluated_command import path_in_package
from ...languages.cpp.common_includes import common_includes
from ...languages.cpp.defined_conditions import is_under_defined
from ...languages.cpp.file import CppFile, IncludeDirective
from ...languages.cpp.lexer import TOKEN
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.cmake.inner_headers import inner_headers
from ...package.file_role import Role
from ...package.install_table import InstallTable
from ...package.interfaces.interface_file import InterfaceFile
from ...ros.headers import LIBRARIES, SHARED
from ...ros.implied_dependencies import IN_SOURCES, implied_by
from ...ros.libraries import is_named_among, keys_of_header, keys_of_module, stem
from ...ros.names import NameKind
from ...source import Source, Span
from ..cmake.commented_installs import said_in
from .brought_dependencies import Bringer, brought_by
from .commented_installs import is_told_in
from .compiled_sources import (
    certainly_compiled,
    compiled_on_demand,
    compiled_sources,
    only_under_conditions,
    own_compiled,
)
from .declared_dependencies import DeclaredDependencies
from .hand_installs import BY_PAGE, HandInstalls
from .own_places import ELSEWHERE, fetching_words, has_include_folder
from .places_beside_apt import BESIDE_APT, place_beside_apt
from .required_by_cmake import required_modules, required_packages
from .ros1_headers import Ros1Headers
from .ros1_sources import Ros1Sources
from .undeclared_find_package import FindPackageDependencies
from .unnamed_sources import UnnamedSources

"""The end of a type that rosidl generates, behind the name of its package; it begins with what `re` skips ahead to."""
GENERATED = regex(r"[a-z][a-z0-9_]*/(?:msg|srv|action)/[a-z0-9_]+\.hpp")
"""A header that rosidl makes of an interface, behind the name of its package."""
PACKAGE, QUALIFIER = regex(r"[a-z][a-z0-9_]*"), regex(r"[\w:]")

BY_COMMENT = "; a comment here tells to install it by hand, and the key may bring another version"
OF_SYSTEM = frozenset("sys linux net netinet arpa asm bits rpc mach".split())
"""Folders of the C library and of kernels; a package that brings a port to another system may have one of them, too."""
OF_CLIENT_LIBRARIES = frozenset(
    "action_msgs builtin_interfaces composition_interfaces lifecycle_msgs rcl_interfaces rosgraph_msgs service_msgs "
    "statistics_msgs type_description_interfaces unique_identifier_msgs".split()
)
"""Interfaces that rclcpp and its kin hand to their users, whose types are part of their own functions."""


@dataclass(frozen=True, slots=True)
class IncludeUse:
    """A header of another package, and the file that includes it."""

    path: str
    span: Span
    header: str
    is_type: bool = False
    """Whether it is a type of generated code, `nav_msgs::msg::Odometry`, whose header something else includes."""


@dataclass(frozen=True, slots=True)
class IncludedPackage:
    """The provider of some includes: any of the names will do, the first is the one to recommend."""

    names: tuple[str, ...]
    cmake: str
    """The name for find_package."""
    role: Role
    uses: tuple[IncludeUse, ...]


@dataclass(frozen=True)
class IncludeDependencies:
    declared: DeclaredDependencies
    files: PackageFiles
    cmake: CMake
    sources: tuple[CppFile, ...]
    interfaces: tuple[InterfaceFile, ...] = ()
    table: InstallTable = InstallTable()

    @cached_property
    def find_packages(self) -> FindPackageDependencies:
        return FindPackageDependencies(self.declared, self.cmake, self.interfaces)

    @cached_property
    def ros1(self) -> Ros1Sources:
        headers = Ros1Headers(self.declared.facts, self.files, self.declared.workspace)
        return Ros1Sources(headers, self.cmake, self.sources)

    def brought(self) -> Iterator[tuple[IncludedPackage, Bringer]]:
        """Yield what is included and not declared, and comes or may come with something else."""
        for each in self.undeclared():
            if bringer := self.bringer(each):
                yield each, bringer

    def bringer(self, each: IncludedPackage) -> Bringer | None:
        return self.declared.bringer(each.names, runs=False) or self.found_bringer(each)

    def packages(self) -> tuple[IncludedPackage, ...]:
        """Return the packages and libraries whose headers are included, those of tests after those of what is built."""
        return self._packages

    @cached_property
    def _packages(self) -> tuple[IncludedPackage, ...]:
        return tuple(self.included())

    def included(self) -> Iterator[IncludedPackage]:
        """Yield what `packages` returns, found out anew."""
        if not self.declared.is_checked:
            return
        found: dict[tuple[Role, tuple[str, ...], str], list[IncludeUse]] = {}
        unnamed = UnnamedSources(self.files)
        for source, role in compiled_sources(self.cmake, self.sources):
            always = always_included(source)
            is_left = role == "aside" or (self.compiled is None and unnamed.has(source.path))
            for each in source.includes if not is_left else ():
                folder, slash, _ = each.path.partition("/")
                is_certain = not each.is_conditional or folder in always or self.is_switched_on(source, each)
                if (slash or keys_of_header(each.path)) and is_certain and not self.is_own(each.path):
                    names, cmake = self.providers(each.path)
                    is_open = source.path in self.guarded or not self.ros1.headers.may_be_in_ros2(each.path)
                    if names and not is_open and self.outside.isdisjoint((folder, *names)):
                        use = IncludeUse(source.path, each.span, each.path)
                        found.setdefault((role, names, cmake), []).append(use)
        for (role, names, cmake), uses in sorted(found.items(), key=lambda item: item[0][0] == "test"):
            if role != "test" or ("run", names, cmake) not in found:
                yield IncludedPackage(names, cmake, role, tuple(uses))

    def is_switched_on(self, source: CppFile, include: IncludeDirective) -> bool:
        """Return whether the conditions around an include ask for macros that CMake defines for all targets."""
        macros = self.macros
        return bool(macros) and is_under_defined(source.source.text, include.span.start, macros)

    @cached_property
    def macros(self) -> frozenset[str]:
        calls = self.cmake.named("add_definitions", "add_compile_definitions")
        words = (word for call in calls if not (call.maybe or call.folder or call.testing) for word in call.words)
        texts = (word.text for word in words if word.is_known and not word.maybe)
        return frozenset(text.removeprefix("-D").partition("=")[0] for text in texts if not text.endswith("=0"))

    @cached_property
    def outside(self) -> frozenset[str]:
        """The parts of include folders that CMake names outside of the package: it needs no package to find them."""
        calls = self.cmake.named("include_directories", "target_include_directories")
        words = ((word.text, path_in_package(word.text, call.folder)) for call in calls for word in call.words)
        return frozenset(part for text, path in words if path is None and "../" in text for part in text.split("/"))

    @cached_property
    def guarded(self) -> frozenset[str]:
        """The headers that the package's files include under a condition alone."""
        return only_under_conditions(self.cmake, self.sources)

    def are_passed_on(self, each: IncludedPackage) -> bool:
        """Return whether only headers for others include it: the package itself compiles none of them."""
        known = self.compiled if each.role != "test" else None
        return known is not None and known.isdisjoint(use.path for use in each.uses)

    def are_idle(self, each: IncludedPackage) -> bool:
        """Return whether no file that includes it is compiled here, where others are, or installed for others.

        Where no package of the workspace builds against this one, nobody compiles a header that is only installed.
        """
        installed = {row.source for row in self.table.of("header")}
        is_seen = not self.compiled and not installed.isdisjoint(use.path for use in each.uses)
        name, needing = self.declared.facts.name, self.declared.workspace.needing(self.declared.facts.name)
        is_seen = is_seen and self.declared.workspace.is_built_against(name)
        is_seen = is_seen and any(self.offered & facts.included_headers - facts.header_files for facts in needing)
        return self.are_passed_on(each) and not is_seen

    def are_required(self, each: IncludedPackage) -> bool:
        """Return whether CMake itself requires it, and so stops before the compiler does."""
        if not {each.cmake, *each.names}.isdisjoint(required_packages(self.cmake)):
            return True
        modules = tuple(required_modules(self.cmake))
        return any(is_named_among(name, modules) for name in each.names)

    @cached_property
    def offered(self) -> frozenset[str]:
        """The headers of include/, as others include them."""
        return frozenset(path.removeprefix("include/") for path in self.files.below("include/"))

    @cached_property
    def compiled(self) -> set[str] | None:
        """The files that the package's own build opens; None where unknown."""
        return own_compiled(self.cmake, self.sources)

    def are_found_quietly(self, each: IncludedPackage) -> bool:
        """Return whether CMake looks for it without need, and compiles what includes it under a condition alone."""
        names = {one.name for one in self.cmake.packages if not one.is_required}
        is_sought = not {each.cmake, *each.names}.isdisjoint(names)
        is_sought = is_sought or bool(names and self.find_packages.matching_names(each.cmake, names))
        return is_sought and self.are_optional(each)

    def are_for_ros1(self, each: IncludedPackage) -> bool:
        """Return whether it is declared under a condition that does not hold, and no build is sure to need it."""
        declared = {one.name for one in self.declared.manifest.dependencies if one.condition}
        is_left = declared.intersection(each.names) and not self.declared.has(each.names)
        return bool(is_left) and self.certain.isdisjoint(use.path for use in each.uses)

    @cached_property
    def certain(self) -> set[str]:
        return certainly_compiled(self.cmake, self.sources)

    def why_by_hand(self, cmake: str, names: Iterable[str], headers: Iterable[str] = ()) -> str:
        """Return what is said of a library that a page tells people to install by hand, or that CMake takes from where
        they put it or has the compiler look for there; "" for others.
        """
        keys = [each for each in names if self.declared.workspace.index.is_key(each)]
        every = (cmake, *keys, *headers) if keys else ()
        if place := place_beside_apt(self.cmake, every) if keys else "":
            return BESIDE_APT.format(place)
        if keys and HandInstalls(self.files).has(every):
            return BY_PAGE
        if keys and is_told_in("\n".join(map(said_in, self.cmake.files)), every):
            return BY_COMMENT
        return ELSEWHERE if keys and has_include_folder([*headers], self.cmake) else ""

    def may_be_submodule(self, each: IncludedPackage) -> bool:
        """Return whether it is a library that a submodule may hold, which CMake looks into and which is not here."""
        return self.opens_submodule and all(keys_of_header(use.header) for use in each.uses)

    @cached_property
    def opens_submodule(self) -> bool:
        calls = self.cmake.named("include_directories", "target_include_directories", "add_subdirectory")
        paths = (path_in_package(word.text, call.folder) for call in calls for word in call.words)
        return any(path and self.files.absent.submodule_of(path) for path in paths)

    def are_optional(self, each: IncludedPackage) -> bool:
        """Return whether only files include it that an option must ask for."""
        return all(use.path in self.on_demand for use in each.uses)

    @cached_property
    def on_demand(self) -> set[str]:
        """The files that are compiled under a condition alone."""
        return compiled_on_demand(self.cmake, self.sources)

    def providers(self, header: str) -> tuple[tuple[str, ...], str]:
        """Return the providers of a header, and its name in CMake; no providers where they are unknown."""
        folder = header.partition("/")[0]
        if folder in OF_SYSTEM:
            return (), folder
        if folder in LIBRARIES:
            is_fetched = is_named_among(folder, self.fetched)
            return () if is_fetched else self.find_packages.providers(LIBRARIES[folder]), LIBRARIES[folder]
        around = sorted(self.declared.workspace.with_header(header))
        if around:
            return (tuple(around), around[0]) if len(around) == 1 or folder in around else ((), folder)
        if keys := keys_of_header(header):
            return (() if self.is_at_hand(header) else keys), stem(header)
        facts = self.declared.workspace.named(folder)
        known = (self.is_package(folder) or GENERATED.fullmatch(header) is not None) and folder not in SHARED
        if not known or (facts is not None and facts.is_metapackage):
            return (), folder
        return (folder,), folder

    def is_package(self, name: str) -> bool:
        """Return whether a name is that of a package: a known one, or one that others of the workspace declare."""
        kind = self.declared.workspace.kind_of(name)
        is_declared = "_" in name and kind is not NameKind.KEY and bool(self.declared.workspace.needing(name))
        return kind is NameKind.PACKAGE or is_declared

    def is_at_hand(self, name: str) -> bool:
        """Return whether a library of the system is declared by another of its names, or CMake gets it itself."""
        return is_named_among(name, self.declared.names) or is_named_among(name, self.fetched)

    @cached_property
    def fetched(self) -> tuple[str, ...]:
        """The words of commands that download or add what the system need not have, and what submodules are called."""
        calls = [each for each in self.cmake.unreachable if each.name == "externalproject_add"]
        calls += self.cmake.named("add_subdirectory", "externalproject_add", "fetchcontent_declare", "ament_vendor")
        words = (word.text for call in calls for word in call.words)
        return (*words, *fetching_words(self.cmake), *self.files.absent.submodule_names)

    def is_own(self, header: str) -> bool:
        """Return whether a header is the package's own: it exists, or may be generated in a folder that does."""
        folder = header.rpartition("/")[0]
        return (
            header.partition("/")[0] == self.declared.facts.name
            or (folder != "" and folder in self.path_endings)
            or header in self.path_endings
            or header in self.inner
        )

    @cached_property
    def inner(self) -> frozenset[str]:
        return inner_headers(self.cmake)

    @cached_property
    def path_endings(self) -> frozenset[str]:
        """The last parts of every path and folder: headers are found from wherever CMake looks."""
        paths = [path.split("/") for path in (*self.files.paths, *self.files.folders)]
        return frozenset("/".join(parts[-n:]) for parts in paths for n in (1, 2, 3, 4))

    def undeclared(self) -> tuple[IncludedPackage, ...]:
        """Return what is included and not declared, but for what find_package names as well."""
        return self._undeclared

    @cached_property
    def _undeclared(self) -> tuple[IncludedPackage, ...]:
        return tuple(self.without_brought_types(self.lacking()))

    def without_brought_types(self, found: Iterable[IncludedPackage]) -> Iterator[IncludedPackage]:
        """Yield some packages, but for types alone whose package certainly comes with another one of them."""
        every = list(found)
        for each in every:
            others = (one for one in every if not one.uses[0].is_type and one.role in ("run", each.role))
            first = {one.names[0] for one in others}
            is_brought = each.uses[0].is_type and each.names[0] in brought_by(sorted(first), self.declared.workspace)
            if not is_brought:
                yield each

    def lacking(self) -> Iterator[IncludedPackage]:
        """Yield what `undeclared` returns, found out anew."""
        there = implied_by(self.declared.names, IN_SOURCES)
        reported = {missing.found.name for missing in self.find_packages.missing()}
        named = {name for missing in self.find_packages.missing() for name in missing.names}
        for each in self.packages():
            is_reported = each.cmake in reported or not named.isdisjoint(each.names)
            is_reported = is_reported or bool(named and self.find_packages.matching_names(each.cmake, named))
            is_settled = is_reported or bool(there.intersection(each.names)) or self.are_found_quietly(each)
            is_settled = is_settled or self.are_for_ros1(each)
            if not is_settled and not self.is_declared(each):
                reported.update(each.names)
                yield each
        for each in self.typed():
            is_told = bool((reported | there).intersection(each.names))
            if not is_told and not self.is_declared(each) and not self.are_found_quietly(each):
                yield each

    def typed(self) -> Iterator[IncludedPackage]:
        """Yield the packages whose types are named, each by the first, those of tests after those of what is built."""
        found: dict[str, IncludedPackage] = {}
        if not self.declared.is_checked:
            return
        for source, role in sorted(compiled_sources(self.cmake, self.sources), key=lambda each: each[1] == "test"):
            for package, span in named_types(source.source) if role != "aside" else ():
                if package in found or package in OF_CLIENT_LIBRARIES:
                    continue
                known = self.declared.workspace.kind_of(package) is NameKind.PACKAGE
                if known and is_code(source.source, span.start):
                    use = IncludeUse(source.path, span, source.source.slice(span), is_type=True)
                    found[package] = IncludedPackage((package,), package, role, (use,))
        yield from found.values()

    def found_bringer(self, each: IncludedPackage) -> Bringer | None:
        return self.required_bringer(each.names, in_tests=each.role == "test")

    def required_bringer(self, names: tuple[str, ...], *, in_tests: bool) -> Bringer | None:
        """Return the package or library that CMake stops without, declared or not, and that brings some name."""
        found = [one for one in self.cmake.packages if one.is_required and not one.call.maybe]
        named = {one.name for one in found if in_tests or not one.call.testing}
        wanted = {key for name in named for key in (name, *self.find_packages.providers(name)[:1])}
        there = brought_by(sorted(wanted), self.declared.workspace)
        by_package = next((Bringer(there[name]) for name in names if name in there), None)
        return by_package or self.module_bringer(names, in_tests)

    def module_bringer(self, names: tuple[str, ...], in_tests: bool) -> Bringer | None:
        """Return the library of a module of pkg-config that does so: none that would do for a name itself, as only one
        of these is told, or that comes with it.
        """
        workspace, modules = self.declared.workspace, required_modules(self.cmake, with_tests=in_tests)
        wanted = dict.fromkeys(key for each in modules for key in keys_of_module(each)[:1] if key not in names)
        there = brought_by(wanted, workspace)
        found = [(name, there[name]) for name in names if name in there]
        return next((Bringer(by) for name, by in found if by not in brought_by([name], workspace)), None)

    def is_declared(self, each: IncludedPackage) -> bool:
        return self.declared.has(each.names) or bool(self.find_packages.matching_names(each.cmake, self.declared.names))


def always_included(source: CppFile) -> frozenset[str]:
    """Return the folders of headers that all branches of a condition include."""
    if not any(each.is_conditional for each in source.includes):
        return frozenset()
    return common_includes(source.source.text, {each.span.start for each in source.includes})


def named_types(source: Source) -> Iterator[tuple[str, Span]]:
    """Yield the generated types that a C++ text names, each with its package, also in comments and strings."""
    from ...package.interfaces.generated_types import generated_types  # a package without C++ needs none

    for each in generated_types(source):
        before = source.text[max(0, each.start - 3) : each.start]
        is_whole = before[-1:] != ":" or (before[-2:] == "::" and not QUALIFIER.match(before[:-2]))
        if is_whole and PACKAGE.fullmatch(each.package):
            yield each.package, Span(each.start, each.end)


def is_code(source: Source, offset: int) -> bool:
    """Return whether an offset of a C++ text is in no comment and no string."""
    known = vars(source)
    if "hidden_spans" not in known:
        known["hidden_spans"] = [match.span() for match in TOKEN.finditer(source.text)]
    hidden: list[tuple[int, int]] = known["hidden_spans"]
    at = bisect_right(hidden, (offset, len(source.text)))
    return at == 0 or offset >= hidden[at - 1][1]
