"""Programs of CMake none of whose sources has a `main()` (CMK125)."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from functools import cached_property

from ...languages.cmake.evaluated_command import path_in_package
from ...languages.cmake.targets import Target
from ...languages.cmake.values import Word
from ...languages.cpp.file import CppFile
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_package import CMakePackage
from ...package.cmake.referenced_paths import sources_in
from ...package.cmake.target_links import TargetLinks
from ..depends.compiled_sources import own_compiled
from ..depends.header_inclusions import Inclusions

PLAIN = frozenset({"add_executable"})
SOURCES = (".cpp", ".cc", ".cxx", ".c++", ".c")
HEADERS = (".hpp", ".h", ".hh", ".hxx", ".ipp", ".tpp")
MAY_BE_MAIN = regex(r"[Mm]ain\s*\(|MAIN|BOOST_TEST_MODULE|#[ \t]*include[ \t]*[<\"][^\n]*[Mm]ain")
"""What a file has that has a `main()`, or a macro that makes one; a comment counts too."""
MAIN = regex(r"^int\s+main\s*\(", re.MULTILINE)
MACRO = regex(r"^(?!RCLCPP_|PLUGINLIB_|CLASS_LOADER_|RCUTILS_|Q_)[A-Z][A-Z0-9_]{2,}[ \t]*\(", re.MULTILINE)
"""A macro outside of functions, which may make a `main()` as well."""
COMPONENT = "RCLCPP_COMPONENTS_REGISTER_NODE"
CODE = regex(r"(?m)^[ \t]*(?!//|/\*|\*|#|using\b)\S")
"""A line of C++ that is neither a comment nor for the preprocessor."""
ON_DEMAND = "EXCLUDE_FROM_ALL"
SETTINGS = ("set_target_properties", "target_link_options", "set_property")


@dataclass(frozen=True, slots=True)
class MainlessProgram:
    target: Target
    lost: str
    """The one file with a `main()` that no target has, in the folder of a source; "" where there is none."""
    is_component: bool
    is_whole: bool
    """Whether it is built by default, all of its sources are there, and all that it is linked with is known."""
    is_left: bool = False
    """Whether a comment in a source says that the code is still to be written."""


@dataclass(frozen=True)
class MainlessPrograms:
    package: CMakePackage
    sources: tuple[CppFile, ...]

    def all(self) -> Iterator[MainlessProgram]:
        """Yield the programs of which every source is known; where one is not there, or a library not known, only those
        that have another file with a `main()` next to their sources."""
        cmake = self.package.cmake
        for target in cmake.targets if self.package.is_ament and cmake.is_complete else ():
            is_judged = target.is_built and target.call.name in PLAIN and not (target.call.maybe or target.call.testing)
            paths = self.paths(target) if is_judged else None
            there = [path for path in paths or () if cmake.package_files.has_file(path)]
            given = self.given_main(target) if there and not self.may_have_main(there) else True
            if given is not True:
                is_whole = len(there) == len(paths or ()) and given is False and not cmake.reads_unknown_files
                is_asked = ON_DEMAND in target.options
                if (lost := self.lost(there)) or is_whole:
                    is_component = any(COMPONENT in self.text(path) for path in there)
                    is_left = any(map(self.is_left_to_write, there))
                    yield MainlessProgram(target, lost, is_component, is_whole and not is_asked, is_left)

    def is_left_to_write(self, path: str) -> bool:
        from ..python.left_blank import asks_at_the_top, has_task, is_asked_for

        text = self.text(path)
        return asks_at_the_top(text) or is_asked_for(text, "main") or (not CODE.search(text) and has_task(text))

    def paths(self, target: Target) -> list[str] | None:
        """Return the sources of a target; None where one is not known, or of another language."""
        words = [*target.sources]
        for call in self.package.cmake.named("target_sources"):
            if call.texts[:1] == (target.name,) or not call.words[:1] or not call.words[0].is_known:
                words += [*sources_in(call), *([call.words[0]] if call.maybe else [])]
        found = [self.path(word, target.call.folder) for word in words]
        return None if None in found else [path for path in found if path and not path.endswith(HEADERS)]

    def path(self, word: Word, folder: str) -> str | None:
        path = path_in_package(word.text, folder) if word.is_known and not word.maybe else None
        return path if path is not None and path.endswith((*SOURCES, *HEADERS)) else None

    def text(self, path: str) -> str:
        return self.package.cmake.package_files.readable_text(path)

    @cached_property
    def inclusions(self) -> Inclusions:
        return Inclusions({source.path: source for source in self.sources})

    def may_have_main(self, paths: list[str]) -> bool:
        """Return whether a file, or one that it includes, may have a `main()`; so too where one is not read."""
        if not self.inclusions.files.keys() >= set(paths):
            return True
        reached = self.inclusions.reached(paths)
        others = (other for path in reached for other in self.others_in(path))
        texts = [self.text(path) for path in (*reached, *others)]
        return any(not text or MAY_BE_MAIN.search(text) or MACRO.search(text) for text in texts)

    def others_in(self, path: str) -> Iterator[str]:
        """Yield the files of any other ending that one includes (`app.inc`), wherever they lie in the package."""
        names = {posixpath.basename(each.path) for each in self.inclusions.files[path].includes}
        names = {each for each in names if not each.endswith((*SOURCES, *HEADERS))}
        paths = self.package.cmake.package_files.paths if names else ()
        return (each for each in paths if posixpath.basename(each) in names)

    def given_main(self, target: Target) -> bool | None:
        """Return whether a library or a setting may bring one; None where a library can't be evaluated."""
        cmake, waiting, seen = self.package.cmake, [target.name], set[str]()
        links, is_known = TargetLinks(cmake), True
        while waiting:
            name = waiting.pop()
            for link in links.of(name) if name not in seen else ():
                own = cmake.target(link.word.text)
                paths = self.paths(own) if own is not None else []
                if "main" in link.word.text.lower() or paths is None or (paths and self.may_have_main(paths)):
                    return True
                is_known &= link.word.is_known
                waiting += [own.name] if own is not None else []
            seen.add(name)
        set_for = (call for call in cmake.named(*SETTINGS) if target.name in call.texts)
        is_set = any("OPTIONS" in str(call.texts) or "-nostartfiles" in call.texts for call in set_for)
        return True if is_set else False if is_known else None

    def lost(self, paths: list[str]) -> str:
        folders, compiled = {posixpath.dirname(path) for path in paths}, own_compiled(self.package.cmake, self.sources)
        neighbours = (each.path for each in self.sources if posixpath.dirname(each.path) in folders)
        others = [path for path in neighbours if path.endswith(SOURCES) and path not in (compiled or ())]
        written = "".join(file.source.text for file in self.package.cmake.files)
        found = [path for path in others if MAIN.search(self.text(path)) and posixpath.basename(path) not in written]
        return found[0] if len(found) == 1 else ""
