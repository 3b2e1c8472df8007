"""Packages that CMake looks for, hands to ament or exports, and that do not exist: a slip, or a target."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.values import Word
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_package import CMakePackage
from ...package.workspace import Workspace
from ...ros.aliases import keys_for_cmake
from ..repository.foreign_images import foreign_image
from .consumers import Consumers
from .foreign_targets import TAKING, ForeignTargets, foreign_targets
from .found_elsewhere import looks_outside, may_be_found_elsewhere
from .misplaced_package_arguments import KEYWORDS, imported_targets, keywords, variables_of_libraries
from .misspelt_packages import misspelt_argument, misspelt_search
from .mistyped_package import HANDED, MistypedPackage
from .package_names import PackageNames


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
        yield from variables_of_libraries(self.package.cmake, self.names.found)
        yield from keywords(self.package.cmake)
        yield from imported_targets(self.package.cmake, self.names.found)

    @cached_property
    def names(self) -> PackageNames:
        return PackageNames(self.package, self.workspace)

    def foreign(self) -> Iterator[ForeignTargets]:
        """Yield the calls that are given targets of packages."""
        return foreign_targets(self.package)

    def named(self) -> Iterator[tuple[Word, EvaluatedCommand]]:
        """Yield the packages that commands are given; of those that are looked for, the required ones."""
        cmake = self.package.cmake
        for call in cmake.named(*TAKING):
            yield from ((word, call) for word in call.words[TAKING[call.name] :] if word.text not in KEYWORDS)
        for found in cmake.packages:
            if found.is_required and not found.is_quiet:
                yield found.word, found.call

    def judged(self, word: Word, call: EvaluatedCommand) -> MistypedPackage | None:
        """Return what is wrong with an argument that should be a package; None where it may be one."""
        names = self.names
        if self.is_own(word, call):
            return MistypedPackage(word, call, "own", is_certain=not any(looks_outside(self.package.cmake)))
        if call.name == HANDED and self.is_own_target(word.text):
            return MistypedPackage(word, call, "target")
        if names.is_known(word.text):
            written = names.found_library(word.text) if call.name == HANDED else None
            return MistypedPackage(word, call, "case", written, is_certain=False) if written is not None else None
        if call.name != HANDED and names.is_found_in_other_case(word.text):
            return None
        if call.name not in TAKING:
            return misspelt_search(word, call, names) if names.must_be_of_ros(word.text) else None
        if word.text in names.found | names.found_in_capitals or keys_for_cmake(word.text):
            return None  # a package that is found may find a library, as cv_bridge finds OpenCV
        return self.judged_argument(word, call)

    def judged_argument(self, word: Word, call: EvaluatedCommand) -> MistypedPackage | None:
        """Return what is wrong with a name that no package has, in a command that takes packages."""
        names = self.names
        if self.package.cmake.target(word.text) is not None:
            return MistypedPackage(word, call, "target")
        if (misspelt := misspelt_argument(word, call, names.found | names.declared)) is not None:
            return misspelt
        if (alike := names.alike(word.text)) is not None:
            is_certain = alike.lower() == word.text.lower() and self.workspace.is_cased(alike)
            return MistypedPackage(word, call, "misspelt", alike, is_certain=is_certain)
        return MistypedPackage(word, call, "nowhere", is_certain=False) if self.is_nowhere(word, call) else None

    def may_be_elsewhere(self, each: MistypedPackage) -> bool:
        """Return whether what is looked for under a name that is near to another one may be a package of its own."""
        return each.is_guess and may_be_found_elsewhere(each.word.text, self.package.cmake, self.workspace)

    def may_be_brought(self, each: MistypedPackage) -> str:
        """Return what to add to the message where an image that the repository builds on may have the package."""
        image = foreign_image(self.package.cmake.package_files) if each.is_guess else None
        return image.may_bring if image is not None else ""

    def is_nowhere(self, word: Word, call: EvaluatedCommand) -> bool:
        """Return whether an argument is no known package, and no other command and no file names it."""
        cmake, name = self.package.cmake, word.text
        unclear = not cmake.is_complete or cmake.reads_unknown_files or not self.names.must_be_of_ros(name)
        if unclear or keys_for_cmake(name) or (call.name == HANDED and self.names.may_be_found(name)):
            return False
        return not any(name in text for each in cmake.calls if each.name not in TAKING for text in each.texts)

    def is_own(self, word: Word, call: EvaluatedCommand) -> bool:
        """Return whether a package looks for itself, before it is installed, and brings no module to be found by."""
        is_its_name = word.text == self.package.facts.name == self.package.cmake.project_name
        is_looked_for = call.name == "find_package" and self.package.is_ament
        return is_its_name and is_looked_for and self.names.must_be_of_ros(word.text)

    def is_own_target(self, name: str) -> bool:
        """Return whether a name is that of the package itself, which it does not find, and of a target of it."""
        cmake = self.package.cmake
        if name != self.package.facts.name or name in self.names.found or cmake.target(name) is None:
            return False
        texts = (f"{name}_FOUND", "${PROJECT_NAME}_FOUND")  # where someone says that it is found
        return not cmake.reads_unknown_files and not any(e in file.source.text for file in cmake.files for e in texts)
