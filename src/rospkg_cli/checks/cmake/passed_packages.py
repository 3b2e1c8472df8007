"""Packages whose targets or headers a library passes on to those that link it."""

from __future__ import annotations

from functools import cached_property

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.installed_headers import PublicHeaders
from ...package.cmake.target_links import TargetLink
from ...ros.aliases import NOTHING_NEEDED, keys_for_cmake
from ...ros.link_targets import MESSAGES
from ...ros.read_table import rows
from .exported_names import ExportedNames

IN_OTHERS = frozenset({"Boost", "Eigen3", "OpenMP", "Qt5"})
"""Libraries that many other ones look for themselves."""
VARIABLE = regex(r"\$\{([\w.+-]+?)_TARGETS\}")
"""Targets by a variable. `${std_msgs_LIBRARIES}` are paths of libraries, which need not be found again."""


@dataclass(frozen=True)
class PassedPackages:
    headers: PublicHeaders
    exports: ExportedNames

    def package_of(self, link: TargetLink) -> str:
        """Return the package that an argument of a link refers to: `pkg::lib`, `${pkg_TARGETS}`, `pkg`."""
        if link.package:
            return link.word.text
        if "::" in link.word.text and link.word.is_known:
            return link.word.text.partition("::")[0]
        match = VARIABLE.fullmatch(self.headers.package.cmake.source_text(link.word).strip('"'))
        return match.group(1) if match else ""

    def is_target(self, package: str, link: TargetLink) -> bool:
        """Return whether a link passes on a target of a package, which CMake looks for wherever the library is linked.

        `ament_target_dependencies()` does so with packages that have targets.
        """
        has_some = any(each != "-" for each in rows("cmake_targets.txt").get(package, ()))
        of_ros = MESSAGES.fullmatch(package) is not None or has_some
        if package not in self.declared:  # DEP104 reports it, too
            return package in self.found and MESSAGES.fullmatch(package) is not None
        return package in self.found and (of_ros or not link.package)

    def is_library(self, package: str, link: TargetLink) -> bool:
        """Return whether a link passes on a target of a library of the system (`yaml-cpp::yaml-cpp`), which is found.

        What other libraries or packages use may come with them, and a module of the package may find it for users.
        """
        keys = frozenset(keys_for_cmake(package)) - {NOTHING_NEEDED}
        there = self.exports.there[0]
        others = {each for each in there if keys_for_cmake(each)} if package in IN_OTHERS else set[str]()
        is_own = any(f"Find{package}.cmake" in path for path in self.headers.package.cmake.package_files.paths)
        lower = {each.lower() for each in there}
        is_listed = not keys.isdisjoint(there) or bool(others) or is_own or package.lower() in lower
        return "::" in link.word.text and package in self.found and bool(keys) and not is_listed

    @cached_property
    def needed(self) -> frozenset[str]:
        """The ROS packages that are declared, certainly looked for, and included by installed headers.

        A library of the system is declared under another name, and often found with the package's own find module.
        """
        return self.found & self.declared & {name for _, _, name in self.headers.included_packages()}

    @cached_property
    def declared(self) -> frozenset[str]:
        return frozenset(each.name for each in self.headers.package.manifest.dependencies)

    @cached_property
    def found(self) -> frozenset[str]:
        """The packages that are certainly looked for, outside of tests."""
        packages = self.headers.package.cmake.packages
        return frozenset(
            each.name for each in packages if each.is_required and not each.call.testing and not each.call.maybe
        )
