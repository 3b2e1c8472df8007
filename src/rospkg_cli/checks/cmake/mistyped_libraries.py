"""Libraries that something is linked with by a plain name, one or two letters off one that the package builds."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...languages.cmake.values import UNKNOWN, Word
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.cmake.target_links import TargetLinks
from ...suggest import near_names
from .name_slips import digits, is_clear_slip
from .target_references import TargetReferences

PLAIN = regex(r"[A-Za-z_][\w-]*")
SHORTEST = 5
"""Letters that a name needs so that a similar one is not another library."""
SHORT = 8
"""Letters of a name from which two may be wrong."""
FOLDERS = ("link_directories", "target_link_directories")
SEARCHES = ("find_library", "pkg_check_modules", "pkg_search_module")


@dataclass(frozen=True)
class MistypedLibraries:
    cmake: CMake

    def all(self) -> Iterator[tuple[Word, str, bool]]:
        """Yield each argument once, with the target that is intended, and whether CMake certainly gets there.

        Where other files may make targets, or under a condition, only long names.
        """
        if not self.cmake.is_complete:
            return
        unclear = self.cmake.reads_unknown_files or UNKNOWN in self.named or self.may_be_elsewhere
        seen: set[tuple[str, int, str]] = set()
        for link in TargetLinks(self.cmake).all:
            word = link.word
            key = (word.path, word.span.start, word.text)
            maybe = link.call.maybe or word.maybe or unclear
            if link.package or key in seen or not PLAIN.fullmatch(word.text):
                continue
            seen.add(key)
            near = self.nearest(word.text) if word.text not in self.named else None
            if near == link.target:  # no target is linked with itself: the library lies elsewhere
                continue
            if near is not None and (not maybe or is_clear_slip(word.text, near)):
                yield word, near, not maybe

    def nearest(self, name: str) -> str | None:
        """Return the one library of the package that is intended by a name with the same digits."""
        if len(name) < SHORTEST or self.is_file(name):
            return None
        alike = (each for each in self.libraries if digits(each) == digits(name))
        near = near_names(name, alike, 1 if len(name) < SHORT else 2)
        return near[0] if len(near) == 1 else None

    def is_file(self, name: str) -> bool:
        """Return whether the package brings a library of that name, already built."""
        return any(path.rpartition("/")[2].startswith(f"lib{name}.") for path in self.cmake.package_files.paths)

    @property
    def may_be_elsewhere(self) -> bool:
        """Whether the linker gets a folder that may hold libraries which nothing here builds."""
        return any(True for _ in self.cmake.named(*FOLDERS))

    @cached_property
    def libraries(self) -> frozenset[str]:
        return frozenset(each.name for each in self.cmake.targets if each.is_library and UNKNOWN not in each.name)

    @cached_property
    def named(self) -> frozenset[str]:
        """All names that may be those of targets or of libraries elsewhere; UNKNOWN among them where one is."""
        searched = (text for call in self.cmake.named(*SEARCHES) for text in call.texts)
        return TargetReferences(self.cmake).names | {*searched, *self.cmake.output_names.values()}
