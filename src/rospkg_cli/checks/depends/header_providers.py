"""Which package or library of the system provides the header that a C++ file includes."""

from __future__ import annotations

from functools import cached_property

from ...files import PackageFiles
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.cmake.inner_headers import inner_headers
from ...ros.headers import LIBRARIES, SHARED
from ...ros.libraries import is_named_among, keys_of_header, stem
from ...ros.names import NameKind
from .declared_dependencies import DeclaredDependencies
from .own_places import fetching_words
from .undeclared_find_package import FindPackageDependencies

GENERATED = regex(r"[a-z][a-z0-9_]*/(?:msg|srv|action)/[a-z0-9_]+\.hpp")
"""A header that rosidl generates of an interface: `nav_msgs/msg/odometry.hpp`."""
OF_SYSTEM = frozenset("sys linux net netinet arpa asm bits rpc mach".split())
"""Folders of the C library and of kernels; a package that ports such headers to another system may have one, too."""


@dataclass(frozen=True)
class HeaderProviders:
    """The providers of headers, as seen from one package: its workspace, its CMake and its own files."""

    declared: DeclaredDependencies
    files: PackageFiles
    cmake: CMake
    find_packages: FindPackageDependencies

    def of(self, header: str) -> tuple[tuple[str, ...], str]:
        """Return the packages or keys that provide a header, and the name for find_package; () where none is known."""
        folder = header.partition("/")[0]
        if folder in OF_SYSTEM:
            return (), folder
        if folder in LIBRARIES:
            is_fetched = is_named_among(folder, self.fetched)
            return () if is_fetched else self.find_packages.provided.of(LIBRARIES[folder]), LIBRARIES[folder]
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
        """Return whether a name is that of a known package, or of one that others of the workspace declare."""
        kind = self.declared.workspace.kind_of(name)
        is_declared = "_" in name and kind is not NameKind.KEY and bool(self.declared.workspace.needing(name))
        return kind is NameKind.PACKAGE or is_declared

    def is_at_hand(self, name: str) -> bool:
        """Return whether a library of the system is declared under another of its names, or CMake fetches it."""
        return is_named_among(name, self.declared.names) or is_named_among(name, self.fetched)

    @cached_property
    def fetched(self) -> tuple[str, ...]:
        """The words of commands that download or add libraries, and the names of submodules."""
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
        """The last one to four parts of every path and folder: any folder may be an include directory."""
        paths = [path.split("/") for path in (*self.files.paths, *self.files.folders)]
        return frozenset("/".join(parts[-n:]) for parts in paths for n in (1, 2, 3, 4))
