"""Packages that users of a package's libraries need, and that ament_export_dependencies lacks."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property

from ...languages.cmake.evaluated_command import EvaluatedCommand, path_in_package
from ...languages.cmake.values import UNKNOWN, Word
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.installed_headers import INCLUDES, PLUGINS, PublicHeaders
from ...package.cmake.macro_installs import handed_on
from ...package.cmake.target_links import TargetLink, TargetLinks
from ...package.workspace import Workspace
from ...ros.aliases import NOTHING_NEEDED, keys_for_cmake
from ...ros.config_files import in_other_case
from ...ros.link_targets import MESSAGES
from ...ros.read_table import rows
from .consumers import Consumers
from .found_with import TABLES, found_with

IN_OTHERS = frozenset({"Boost", "Eigen3", "OpenMP", "Qt5"})
"""What many other libraries look for themselves."""
REGISTERS = ("PLUGINLIB_EXPORT_CLASS", "RCLCPP_COMPONENTS_REGISTER_NODE", "CLASS_LOADER_REGISTER_CLASS")
VARIABLE = regex(r"\$\{([\w.+-]+?)_TARGETS\}")
"""Targets by a variable. `${std_msgs_LIBRARIES}` are paths of libraries, which no one has to find again."""
BY_MACRO = {
    "generate_parameter_library": frozenset(
        "fmt rclcpp rclcpp_lifecycle rsl tcb_span tl_expected parameter_traits generate_parameter_library".split()
    ),
    "rosidl_generate_interfaces": frozenset({"rosidl_default_runtime"}),
}
"""What macros export themselves."""


@dataclass(frozen=True)
class MissingExportDependency:
    package: str
    word: Word
    link: TargetLink
    is_target: bool
    """Whether the library is exported as a target: what a target is linked with must be there."""


@dataclass(frozen=True)
class ExportedDependencies:
    headers: PublicHeaders
    workspace: Workspace
    consumers: Consumers

    def missing(self) -> Iterator[MissingExportDependency]:
        """Yield each package that an exported library passes on and that users don't find, neither by name nor with
        another one: an installed header includes it, or the library is a target that hands on one of its."""
        cmake = self.headers.package.cmake
        automatic = cmake.named("ament_auto_package", "autoware_ament_auto_package")
        unclear = not cmake.is_complete or cmake.includes_unknown_files or automatic or UNKNOWN in self.exported
        unclear = unclear or not self.there[1]
        plugins = bool(cmake.named(PLUGINS))
        unused = plugins and not cmake.named(*INCLUDES) and not self.is_built_against
        if unclear or not self.headers.installed or unused:
            return
        seen: set[str] = set()
        for link in TargetLinks(cmake).all:
            package = self.package_of(link)
            passed = link.is_public and link.target in self.libraries and not link.call.maybe and not link.word.maybe
            included = package in self.needed
            is_target = self.is_target(package, link) or self.is_library(package, link)
            needed = included or (link.target in self.targets and is_target)
            if passed and needed and package not in seen and not self.is_there(package):
                seen.add(package)
                yield MissingExportDependency(package, link.word, link, link.target in self.targets)

    def is_there(self, package: str) -> bool:
        """Return whether a package is exported, maybe in other letters, or most likely with one of its family."""
        in_letters = in_other_case(package, self.there[0]) and not self.workspace.is_cased(package)
        return package in self.there[0] | self.of_families or bool(in_letters) or self.is_in_extras(package)

    def is_in_extras(self, package: str) -> bool:
        """Return whether a file of CMake that users of the package run names another package, or may do so."""
        cmake = self.headers.package.cmake
        words = [(word, call.folder) for call in cmake.calls for word in handed_on(call, cmake)]
        paths = [path_in_package(word.text, folder) if word.is_known else None for word, folder in words]
        files = cmake.package_files
        return any(path is None or package in files.readable_text(path) for path in paths)

    def is_target(self, package: str, link: TargetLink) -> bool:
        """Return whether a link hands a target of a package on, which CMake looks for wherever the library is linked.

        `ament_target_dependencies()` does so with packages that have targets.
        """
        has_some = any(each != "-" for each in rows("cmake_targets.txt").get(package, ()))
        of_ros = MESSAGES.fullmatch(package) is not None or has_some
        if package not in self.declared:  # DEP104 reports it, too
            return package in self.found and MESSAGES.fullmatch(package) is not None
        return package in self.found and (of_ros or not link.package)

    def is_library(self, package: str, link: TargetLink) -> bool:
        """Return whether a link hands a target of a library of the system on (`yaml-cpp::yaml-cpp`), which is found.

        What other libraries or packages use may come with them, and a module of the package may find it for users.
        """
        keys = frozenset(keys_for_cmake(package)) - {NOTHING_NEEDED}
        others = {each for each in self.there[0] if keys_for_cmake(each)} if package in IN_OTHERS else set[str]()
        is_own = any(f"Find{package}.cmake" in path for path in self.headers.package.cmake.package_files.paths)
        lower = {each.lower() for each in self.there[0]}
        is_listed = not keys.isdisjoint(self.there[0]) or bool(others) or is_own or package.lower() in lower
        return "::" in link.word.text and package in self.found and bool(keys) and not is_listed

    def is_met(self, found: Sequence[MissingExportDependency]) -> bool:
        """Return whether a package of the workspace stops: a target stops all that link the library, a header those
        that include it."""
        for each in found:
            users = tuple(self.consumers.lacking(each.package))
            headers = None if each.is_target else self.headers.leading_to(each.package)
            if any(headers is None or user.included_headers & headers for user in users):
                return True
        return False

    @property
    def is_built_against(self) -> bool:
        """Whether a package of the workspace builds against this one: plugins and components are only loaded."""
        return bool(self.consumers.builders)

    def package_of(self, link: TargetLink) -> str:
        """Return the package that an argument of a link refers to: `pkg::lib`, `${pkg_TARGETS}`, `pkg`."""
        if link.package:
            return link.word.text
        if "::" in link.word.text and link.word.is_known:
            return link.word.text.partition("::")[0]
        match = VARIABLE.fullmatch(self.headers.package.cmake.source_text(link.word).strip('"'))
        return match.group(1) if match else ""

    @cached_property
    def targets(self) -> frozenset[str]:
        """The names that are exported as targets."""
        cmake = self.headers.package.cmake
        exports = {text for call in cmake.exports for text in call.texts}
        rules = [rule for rule in cmake.installs if rule.export is not None and rule.export.text in exports]
        return frozenset(word.text for rule in rules for word in rule.items)

    @cached_property
    def libraries(self) -> frozenset[str]:
        """The libraries that are exported, for other packages to link."""
        cmake = self.headers.package.cmake
        old = {text for call in cmake.named("ament_export_libraries") if not call.folder for text in call.texts}
        named = self.targets | old
        targets = (cmake.target(name) for name in named)
        return frozenset(
            each.name for each in targets if each is not None and each.is_library and not each.call.testing
        )

    @cached_property
    def calls(self) -> tuple[EvaluatedCommand, ...]:
        return tuple(c for c in self.headers.package.cmake.named("ament_export_dependencies") if not c.folder)

    @cached_property
    def exported(self) -> frozenset[str]:
        """The names that are exported; UNKNOWN among them where one can't be evaluated."""
        cmake = self.headers.package.cmake
        names = {UNKNOWN if UNKNOWN in text else text for call in self.calls for text in call.texts}
        for each in cmake.interface_targets:
            names |= {UNKNOWN if UNKNOWN in word.text else word.text for word in each.dependencies}
        for name, brought in BY_MACRO.items():
            names |= brought if cmake.named(name) else frozenset()
        return frozenset(names)

    @cached_property
    def there(self) -> tuple[frozenset[str], bool]:
        """What is exported, directly or through another package, and whether that is known of all ROS packages."""
        return found_with(self.exported, self.workspace)

    @cached_property
    def of_families(self) -> frozenset[str]:
        """The needed packages that an unknown exported one likely finds: `arm_planning` finds `arm`."""
        tables = [rows(f"{name}.txt") for name in TABLES]
        unknown = [each for each in self.there[0] if self.workspace.named(each) is None]
        unknown = [each for each in unknown if not any(each in table for table in tables)]
        return frozenset(name for name in self.needed if any(each.startswith(f"{name}_") for each in unknown))

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
