"""Which headers a package and its workspace have, and whether the build may make others."""

from __future__ import annotations

import posixpath
from functools import cached_property

from ...light_dataclasses import dataclass
from ...package.cmake.cmake_package import CMakePackage
from ...package.cmake.inner_headers import inner_headers
from ...package.cmake.made_headers import HEADERS, made_header_names, may_make_headers
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from ...ros.interfaces import KINDS, OF_INTERFACES
from .installed_headers import is_installed_header

LOOKING = (
    "find_package find_path find_library pkg_check_modules pkg_search_module externalproject_add fetchcontent_declare"
).split()
MADE = (".pb.h", ".pb.hpp", "_generated.h")
"""What compilers of protobuf and flatbuffers write: by hand too, into folders that git ignores."""


@dataclass(frozen=True)
class KnownHeaders:
    package: CMakePackage
    workspace: Workspace

    def is_there(self, header: str) -> bool:
        """Return whether a file of the package ends with the path, or a package of the workspace has the header."""
        ends = self.by_name.get(posixpath.basename(header), ())
        wanted = f"/{posixpath.normpath(header)}"
        is_own = header in self.inner or any(f"/{path}".endswith(wanted) for path in ends)
        return is_own or is_installed_header(header, self.workspace)

    def knows_own(self, header: str) -> bool:
        """Return whether the build makes no header of that name, and no folder of git or a submodule lacks it."""
        cmake = self.package.cmake
        expected = cmake.package_files.absent.is_expected
        is_made = posixpath.basename(header) in made_header_names(cmake)
        return not is_made and not expected(f"include/{header}") and not self.is_shared(header)

    def is_shared(self, header: str) -> bool:
        """Return whether another package of the workspace, whose headers are not all known, has the folder."""
        others = (facts for facts in self.workspace.packages if facts.name != self.package.facts.name)
        first = header.partition("/")[0]
        return any(
            not facts.knows("header_files") and any(f"{each}/".startswith(f"{first}/") for each in facts.headers)
            for facts in others
        )

    def has_all(self, facts: PackageFacts, folder: str) -> bool:
        """Return whether all headers of another package are known, and it has some in the folder of its name."""
        has_some = any(each.startswith(f"{folder}/") for each in facts.header_files)
        return has_some and facts.knows("header_files") and not self.is_shared(f"{folder}/")

    @property
    def may_have_more(self) -> bool:
        """Whether the package may have headers that are not known: made by its build, or of a library of its name."""
        return self.may_make or self.is_of_library

    @cached_property
    def may_make(self) -> bool:
        return may_make_headers(self.package.cmake)

    @cached_property
    def is_of_library(self) -> bool:
        """Whether CMake looks outside for what is called like the package: its headers may be in the same folder."""
        name, calls = self.package.facts.name.lower(), self.package.cmake.named(*LOOKING)
        texts = {text for call in calls for text in call.texts if not OF_INTERFACES.fullmatch(text)}
        outside = (text for text in texts if text == self.package.facts.name or self.workspace.named(text) is None)
        alike = (text.lower().removeprefix("lib") for text in outside)
        return any(text == name or text.startswith(tuple(f"{name}{sign}" for sign in "-_./:")) for text in alike)

    @cached_property
    def inner(self) -> frozenset[str]:
        return inner_headers(self.package.cmake)

    @cached_property
    def by_name(self) -> dict[str, list[str]]:
        """Name of a file → the paths of all files of the package with that name."""
        found: dict[str, list[str]] = {}
        for path in self.package.cmake.package_files.paths:
            found.setdefault(posixpath.basename(path), []).append(path)
        return found

    @cached_property
    def own(self) -> frozenset[str]:
        """The headers of the package in a folder of its name, as they are included."""
        name = self.package.facts.name
        inside = (f"/{path}".rpartition(f"/{name}/") for path in self.package.cmake.package_files.paths)
        return frozenset(f"{name}/{rest}" for _, found, rest in inside if found and rest.endswith(HEADERS))


def may_be_written(path: str) -> bool:
    """Return whether a path may be that of a header that people write: those of interfaces are generated."""
    parts = path.split("/")
    is_made = parts[-1].endswith(MADE) or (len(parts) > 2 and parts[1] in KINDS)
    return "." in parts[-1] and not is_made and ".." not in parts
