"""Packages that CMake looks for, hands to ament or exports, and that are none, but nearly one, or a target."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import Literal

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.values import Word
from ...lazy_regex import regex
from ...light_dataclasses import dataclass, replace
from ...package.cmake.cmake_package import CMakePackage
from ...package.cmake.set_variables import SetVariables
from ...package.cmake.target_links import TargetLinks
from ...package.workspace import Workspace
from ...ros.aliases import keys_for_cmake
from ...ros.config_files import in_other_case
from ...ros.link_targets import ROS_NAME
from ...ros.names import NameKind
from ...suggest import slips
from ..repository.foreign_images import foreign_image
from .consumers import Consumers
from .foreign_targets import TAKING, ForeignTargets, foreign_targets
from .found_elsewhere import looks_outside, may_be_found_elsewhere
from .mistyped_links import are_swapped, is_likely_slip, nearest

EXPORTED, HANDED = "ament_export_dependencies", "ament_target_dependencies"
AMENT = "ament_"
OF_PACKAGE = regex(r"\$\{(\w+?)_(LIBRARIES|LIBRARY|LIBS|TARGETS|INCLUDE_DIRS?)\}")
KEYWORDS = frozenset({"PUBLIC", "PRIVATE", "INTERFACE", "SYSTEM"})


@dataclass(frozen=True)
class MistypedPackage:
    word: Word
    call: EvaluatedCommand
    kind: Literal["misspelt", "target", "variable", "own", "nowhere", "keyword", "imported", "case"]
    near: str = ""
    """The package that is certainly intended, of one that is misspelt."""
    variable: str = ""
    """The variable that stands where packages belong, as it is written."""
    is_certain: bool = True
    """Whether what the package itself says shows that there is none of this name, whatever is installed."""


@dataclass(frozen=True)
class MistypedPackages:
    package: CMakePackage
    workspace: Workspace
    consumers: Consumers

    def all(self) -> Iterator[MistypedPackage]:
        """Yield each argument once."""
        seen: set[tuple[str, int, str]] = set()
        for word, call in self.named():
            key = (word.path, word.span.start, word.text)
            if word.is_known and not word.maybe and not call.maybe and key not in seen:
                seen.add(key)
                if (found := self.judged(word, call)) is not None:
                    yield found
        yield from self.libraries()
        yield from self.keywords()
        for each in self.package.cmake.packages:
            package, colons, _ = each.name.partition("::")
            if colons and each.word.is_known and not each.word.maybe and not each.call.maybe:
                is_certain = "REQUIRED" in each.call.texts or self.is_linked(each.name, package)
                yield MistypedPackage(each.word, each.call, "imported", package, is_certain=is_certain)

    def is_linked(self, target: str, package: str) -> bool:
        """Return whether something is linked with a target of a package that no other command looks for."""
        links = TargetLinks(self.package.cmake).all
        return package not in self.found and any(link.word.text == target for link in links)

    def foreign(self) -> Iterator[ForeignTargets]:
        """Yield the calls that are given targets of packages."""
        return foreign_targets(self.package)

    def keywords(self) -> Iterator[MistypedPackage]:
        """Yield what `ament_target_dependencies` takes for a package: PRIVATE, and a keyword behind a package."""
        for call in self.package.cmake.named(HANDED):
            first = next(
                (at for at, word in enumerate(call.words) if at and word.text not in KEYWORDS), len(call.words)
            )
            for at, word in enumerate(call.words[1:], 1):
                is_misplaced = word.text in KEYWORDS and at > first and all(each.is_known for each in call.words[:at])
                if (word.text == "PRIVATE" or is_misplaced) and not call.maybe and not word.maybe:
                    yield MistypedPackage(word, call, "keyword")
                    break

    def libraries(self) -> Iterator[MistypedPackage]:
        """Yield variables that hold libraries of a package, where a package belongs."""
        for call in self.package.cmake.named(EXPORTED):
            for argument, words in call.by_argument() if not call.maybe else ():
                match = OF_PACKAGE.fullmatch(argument.text)
                if match is not None and words and not self.variables.may_be_set(f"{match[1]}_{match[2]}"):
                    near = next((each for each in (match[1], match[1].lower()) if each in self.found), None)
                    if near is not None:
                        yield MistypedPackage(words[0], call, "variable", near, argument.text, is_certain=False)

    def named(self) -> Iterator[tuple[Word, EvaluatedCommand]]:
        """Yield the packages that commands are given; of those that are looked for, the required ones."""
        cmake = self.package.cmake
        for call in cmake.named(*TAKING):
            yield from ((word, call) for word in call.words[TAKING[call.name] :] if word.text not in KEYWORDS)
        for found in cmake.packages:
            if found.is_required and not found.is_quiet:
                yield found.word, found.call

    def judged(self, word: Word, call: EvaluatedCommand) -> MistypedPackage | None:
        if self.is_own(word, call):
            return MistypedPackage(word, call, "own", is_certain=not any(looks_outside(self.package.cmake)))
        if call.name == HANDED and self.is_own_target(word.text):
            return MistypedPackage(word, call, "target")
        if self.is_known(word.text):
            written = self.in_other_case(word.text) if call.name == HANDED else None
            return MistypedPackage(word, call, "case", written, is_certain=False) if written is not None else None
        if call.name != HANDED and self.is_found_in_other_case(word.text):
            return None
        if call.name not in TAKING:
            return self.misspelt_search(word, call) if self.is_looked_for_in_vain(word.text) else None
        if word.text in self.found | self.found_in_capitals or keys_for_cmake(word.text):
            return None  # a package that is found may find a library, as cv_bridge finds OpenCV
        if self.package.cmake.target(word.text) is not None:
            return MistypedPackage(word, call, "target")
        if (misspelt := self.misspelt(word, call, self.found | self.declared)) is not None:
            return misspelt
        if (alike := self.alike(word.text)) is not None:
            is_certain = alike.lower() == word.text.lower() and self.workspace.is_cased(alike)
            return MistypedPackage(word, call, "misspelt", alike, is_certain=is_certain)
        return MistypedPackage(word, call, "nowhere", is_certain=False) if self.is_nowhere(word, call) else None

    def may_be_elsewhere(self, each: MistypedPackage) -> bool:
        """Return whether what is looked for under a name that is near to another one may be a package of its own."""
        return is_guess(each) and may_be_found_elsewhere(each.word.text, self.package.cmake, self.workspace)

    def may_be_brought(self, each: MistypedPackage) -> str:
        """Return what is said where an image that the repository builds on may have the package; "" elsewhere."""
        image = foreign_image(self.package.cmake.package_files) if is_guess(each) else None
        return image.may_bring if image is not None else ""

    def alike(self, name: str) -> str | None:
        """Return the one package found whose name differs in case and underscores, or is one of a vendor without the
        words before it."""
        plain = name.replace("_", "").replace("-", "").lower()
        same = {each for each in self.found if each.replace("_", "").replace("-", "").lower() == plain}
        vendors = {each for each in self.found if each.endswith("_vendor") and is_end(each, name)}
        near = same or vendors
        return near.pop() if len(near) == 1 else None

    def is_found_in_other_case(self, name: str) -> bool:
        """Return whether a known package differs in case alone, which CMake may find by this spelling, too."""
        small = name.lower()
        known = self.found | self.declared | self.workspace.names
        same = {*in_other_case(name, known), *((small,) if self.workspace.index.is_package(small) else ())} - {name}
        return bool(same) and not all(map(self.workspace.is_cased, same))

    def in_other_case(self, name: str) -> str | None:
        """Return the library that CMake finds in other letters (`PCL` for `pcl`), where no package is called as it is
        written: the variable `pcl_FOUND` is not that of PCL."""
        cmake = self.package.cmake
        is_whole = cmake.is_complete and not cmake.reads_unknown_files and self.workspace.named(name) is None
        is_there = name in self.found | self.found_in_capitals or self.workspace.index.is_package(name)
        if not is_whole or is_there or any(f"{name}_FOUND" in file.source.text for file in cmake.files):
            return None
        same = [each for each in self.found if each.lower() == name.lower()]
        return same[0] if len(same) == 1 and name.upper() != name else None

    def is_nowhere(self, word: Word, call: EvaluatedCommand) -> bool:
        """Return whether a package is given that nobody knows, and that no other command and no file names."""
        cmake, name = self.package.cmake, word.text
        unclear = not cmake.is_complete or cmake.reads_unknown_files or not self.is_looked_for_in_vain(name)
        if unclear or keys_for_cmake(name) or (call.name == HANDED and self.may_be_found(name)):
            return False
        return not any(name in text for each in cmake.calls if each.name not in TAKING for text in each.texts)

    def may_be_found(self, name: str) -> bool:
        """Return whether it is no name of a ROS package, or a package that is found may find it, as none is released.

        Libraries of the system find no packages of ROS.
        """
        found = (each.name for each in self.package.cmake.packages)
        return "_" not in name or any(self.workspace.named(e) is not None or not self.is_public(e) for e in found)

    def is_public(self, name: str) -> bool:
        return self.workspace.index.is_package(name) or bool(keys_for_cmake(name))

    def is_own(self, word: Word, call: EvaluatedCommand) -> bool:
        """Return whether a package looks for itself, before it is installed, and brings no module to be found by."""
        is_its_name = word.text == self.package.facts.name == self.package.cmake.project_name
        is_looked_for = call.name == "find_package" and self.package.is_ament
        return is_its_name and is_looked_for and self.is_looked_for_in_vain(word.text)

    def is_own_target(self, name: str) -> bool:
        """Return whether a name is that of the package itself, which it does not find, and of a target of it."""
        cmake = self.package.cmake
        if name != self.package.facts.name or name in self.found or cmake.target(name) is None:
            return False
        texts = (f"{name}_FOUND", "${PROJECT_NAME}_FOUND")  # where someone says that it is found
        return not cmake.reads_unknown_files and not any(e in file.source.text for file in cmake.files for e in texts)

    def misspelt(self, word: Word, call: EvaluatedCommand, names: frozenset[str]) -> MistypedPackage | None:
        near = nearest(word.text, names, 2)
        if near is None:
            return None
        return MistypedPackage(word, call, "misspelt", near, is_certain=is_likely_slip(word.text, near))

    def misspelt_search(self, word: Word, call: EvaluatedCommand) -> MistypedPackage | None:
        """Return what `find_package` is meant to find: nearly what is declared, or a slip of one known package.

        One of the workspace counts where CMake finds it elsewhere, too. What is not declared may be another one.
        """
        if (found := self.misspelt(word, call, self.unfound)) is not None:
            return replace(found, is_certain=found.is_certain and self.is_meant(word.text, found.near))
        meant = slips(word.text, self.workspace.names) or slips(word.text, self.workspace.index.packages)
        return (
            MistypedPackage(word, call, "misspelt", meant[0], is_certain=are_swapped(word.text, meant[0]))
            if len(meant) == 1
            else None
        )

    def is_meant(self, name: str, near: str) -> bool:
        """Return whether a package is declared, or is written with two letters swapped, which is no name of its own."""
        return near in self.declared or are_swapped(name, near)

    def is_looked_for_in_vain(self, name: str) -> bool:
        """Return whether a name can only be that of a ROS package: the package brings no module to find it by."""
        modules = (f"/find{name}.cmake", f"/{name}config.cmake", f"/{name}-config.cmake")
        paths = self.package.cmake.package_files.paths
        return ROS_NAME.fullmatch(name) is not None and not any(f"/{p}".lower().endswith(modules) for p in paths)

    @cached_property
    def variables(self) -> SetVariables:
        return SetVariables(self.package.cmake)

    @cached_property
    def unfound(self) -> frozenset[str]:
        """The packages that are declared and that CMake does not look for under their right names, and all of ament."""
        packages = [name for name in self.declared if self.workspace.kind_of(name) is NameKind.PACKAGE]
        tools = [name for name in self.workspace.index.packages if name.startswith(AMENT)]
        return frozenset(packages) - self.found | frozenset(tools)

    def is_known(self, name: str) -> bool:
        """Return whether a name is that of a package or of a rosdep key, or is declared, which DEP001 judges."""
        known = self.workspace.kind_of(name) in (NameKind.PACKAGE, NameKind.KEY)
        return known or name in self.declared or self.workspace.is_available(name) or self.workspace.is_listed(name)

    @cached_property
    def found(self) -> frozenset[str]:
        """The packages that CMake finds."""
        return frozenset(each.name for each in self.package.cmake.packages)

    @property
    def found_in_capitals(self) -> frozenset[str]:
        """The names in capitals of libraries that CMake finds: Eigen3Config.cmake sets EIGEN3_FOUND too.

        `find_package_handle_standard_args(ompl)` sets OMPL_FOUND; what ament writes for a package sets no other.
        """
        found = (name for name in self.found if name != name.lower() or not self.workspace.is_cased(name))
        return frozenset(map(str.upper, found))

    @cached_property
    def declared(self) -> frozenset[str]:
        """The packages that the manifest names, which `ament_auto_…` finds."""
        return frozenset(each.name for each in self.package.manifest.dependencies)


def is_end(one: str, other: str) -> bool:
    """Return whether one name is the other without the words before it."""
    return one.endswith(f"_{other}") or other.endswith(f"_{one}")


def is_guess(each: MistypedPackage) -> bool:
    """Return whether a package is looked for that another one is meant by, as far as names tell."""
    return each.kind == "misspelt" and each.call.name != HANDED
