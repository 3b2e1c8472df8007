"""Unknown packages that CMake requires and package.xml does not declare."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.cmake.find_package import FoundPackage
from ...package.cmake.target_links import TargetLinks
from ...ros.aliases import keys_for_cmake
from ...ros.interfaces import OF_INTERFACES
from ...ros.link_targets import ROS_NAME
from ...ros.names import NameKind
from ...suggest import near_names
from .undeclared_find_package import FindPackageDependencies
from .undeclared_includes import IncludeDependencies

BRINGS = regex(r"(?i)_(?:SOURCE|LIST|BINARY)_DIR\b|externalproject|fetchcontent|\badd_library\s*\([^)]*\bALIAS\b")
"""Words of a Find module that does more than look for a library of the system."""

BRINGING = ("add_subdirectory", "externalproject_add", "fetchcontent_declare", "ament_vendor")
"""Commands by which a package builds or downloads a library itself."""


@dataclass(frozen=True)
class StrangePackage:
    found: FoundPackage
    sentence: str
    is_slip: bool = False
    """Whether it is certainly a misspelt package whose headers are included."""


@dataclass(frozen=True)
class StrangePackages:
    includes: IncludeDependencies

    @property
    def needs(self) -> FindPackageDependencies:
        return self.includes.find_packages

    @property
    def cmake(self) -> CMake:
        return self.includes.cmake

    def all(self) -> Iterator[StrangePackage]:
        """Yield those that are packages of interfaces by their names, or that ament is handed or targets are linked
        with, and libraries whose name is nearly that of a key; any other may come with a declared package."""
        for found in self.strange():
            name = found.name
            is_linked = name in self.needs.needed.handed_to_ament | self.linked and self.may_be_of_ros(name)
            is_handed = is_linked or (name in self.needs.needed.handed_to_ament and self.has_headers(name))
            if is_handed or OF_INTERFACES.fullmatch(name):
                intended = self.intended(name)
                yield StrangePackage(found, unknown_package(name, intended), is_slip=intended is not None)
            elif (bringer := self.bringer(name)) is not None:
                start = (
                    f"CMake requires `{name}`, which `{bringer}` may bring, and package.xml declares nothing like it"
                )
                yield StrangePackage(found, f"{start}; declare what brings it")

    @cached_property
    def linked(self) -> frozenset[str]:
        """The names whose targets (`ugv::core`) or that themselves (`ugv_sdk`) own targets are linked with."""
        links = (each for each in TargetLinks(self.cmake).all if not each.word.maybe and not each.call.maybe)
        return frozenset(each.word.text.partition("::")[0] for each in links if not each.package)

    def strange(self) -> Iterator[FoundPackage]:
        """Yield the packages, each once."""
        seen: set[str] = set()
        declared = self.needs.declared
        for found in self.cmake.packages if declared.is_checked else ():
            name = found.name
            if name in seen or found.call.testing or not self.needs.needed.has(found) or keys_for_cmake(name):
                continue
            seen.add(name)
            is_known = declared.workspace.kind_of(name) in (NameKind.PACKAGE, NameKind.KEY)
            if not is_known and not self.needs.is_declared_alike(name) and not self.is_at_hand(name):
                yield found

    def has_headers(self, name: str) -> bool:
        """Return whether a name of one word is that of a package whose headers are included, as `keisan/angle.hpp`."""
        folders = {each.path.partition("/")[0] for file in self.includes.sources for each in file.includes}
        return name in folders and ROS_NAME.fullmatch(name) is not None and "_vendor" not in name

    def may_be_of_ros(self, name: str) -> bool:
        """Return whether a name is no module that a vendor's package brings, as `sdl2_vendor` does `sdl2_custom`."""
        first, words, _ = name.partition("_")
        vendors = (each for each in self.needs.declared.names if each.endswith("_vendor"))
        return bool(words) and ROS_NAME.fullmatch(name) is not None and not any(e.startswith(first) for e in vendors)

    def is_at_hand(self, name: str) -> bool:
        """Return whether the package itself brings a library, or a module that may do more than find it."""
        lower, files = name.lower(), self.cmake.package_files
        words = (text.lower() for call in self.cmake.named(*BRINGING) for text in call.texts)
        if self.cmake.target(name) is not None or any(lower in word for word in words):
            return True
        configs, paths = (f"/{lower}config.cmake", f"/{lower}-config.cmake"), [f"/{each}" for each in files.paths]
        modules = [path[1:] for path in paths if path.lower().endswith(f"/find{lower}.cmake")]
        brings = any(BRINGS.search(files.readable_text(path)) for path in modules)
        return brings or any(path.lower().endswith(configs) for path in paths)

    def bringer(self, name: str) -> str | None:
        """Return the package or key that may bring a library, where nothing that is declared does."""
        index = self.needs.declared.workspace.index
        alike = [each for each in names_alike(name) if index.is_package(each) or index.is_key(each)]
        names = tuple(each for each in alike if self.needs.provided.is_installable(each))
        return names[0] if names and self.needs.bringer(name, names) is None else None

    def intended(self, name: str) -> str | None:
        """Return the one package whose headers are included and that CMake looks for under a name a letter off."""
        found = {each.name for each in self.cmake.packages}
        near = near_names(name, {each.cmake for each in self.includes.packages()} - found, 1)
        return near[0] if len(near) == 1 else None


def names_alike(name: str) -> tuple[str, ...]:
    """Return the names that a package of ROS, a vendor package or one of Debian may have for what CMake looks for."""
    lower = name.lower()
    debian, own = lower.replace("_", "-"), lower.replace("-", "_")
    return (f"{own}_vendor", f"lib{debian}-dev", f"{debian}-dev", lower, f"lib{debian}", f"{own}_core")


def unknown_package(name: str, intended: str | None) -> str:
    start = f"CMake requires `{name}`"
    if intended is not None:
        return f"{start}, which is no known package; did you mean `{intended}`, whose headers are included?"
    return (
        f"{start}, and package.xml does not declare it: where it is a package of the workspace, colcon may build this "
        "one first; declare it"
    )
