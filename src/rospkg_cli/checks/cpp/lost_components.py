"""Components of Boost, Qt and OpenCV that a target needs and that no `find_package()` asks for (CMK128)."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...languages.cmake.values import UNKNOWN
from ...languages.cpp.code_text import code_text
from ...languages.cpp.file import CppFile
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_facts import SEARCHES
from ...package.cmake.cmake_package import CMakePackage
from ...package.cmake.foreign_commands import foreign_commands
from ...package.cmake.target_links import TargetLinks
from ...ros.components import ALWAYS, PLAIN, component_of_call, is_component, with_needed
from ...source import Span
from ..depends.compiled_sources import own_compiled

OF_CV = regex(r"(?<![\w:])cv::(\w+)")
LITTLE = {"cv_bridge": ("core", "imgproc", "imgcodecs", "calib3d"), "image_transport": ()}
"""Packages that find some components of OpenCV at most."""
KEY = regex(r"lib|.*-")
"""How only keys of rosdep begin, and no packages that CMake finds for their users."""


@dataclass(frozen=True, slots=True)
class LostComponent:
    library: str
    component: str
    path: str
    span: Span
    used: str
    """The target that is linked, or what is called."""
    stranger: str
    """A package that may find the component for itself; "" where all are known."""


@dataclass(frozen=True)
class LostComponents:
    package: CMakePackage
    sources: tuple[CppFile, ...]

    def all(self) -> Iterator[LostComponent]:
        """Yield each component once, where all that looks for packages is known."""
        cmake = self.package.cmake
        unclear = not cmake.is_complete or cmake.reads_unknown_files or any(UNKNOWN in e.name for e in cmake.packages)
        if unclear or next(foreign_commands(cmake), None) is not None:
            return
        yield from self.linked()
        yield from self.called()

    def asked(self, library: str) -> frozenset[str] | None:
        """Return the components that are asked for, with all that come along; None where that is not known."""
        names: set[str] = set()
        for each in self.package.cmake.packages:
            if each.name == library:
                if any(not word.is_known for word in each.components) or "OPTIONAL_COMPONENTS" in each.call.texts:
                    return None
                names.update(word.text.removeprefix("opencv_") for word in each.components)
            elif library.startswith("Qt") and each.name.startswith(library):
                names.add(each.name.removeprefix(library))
        return with_needed(library, names)

    def is_found(self, library: str) -> bool:
        return any(each.name == library for each in self.package.cmake.packages)

    def linked(self) -> Iterator[LostComponent]:
        seen: set[str] = set()
        for link in TargetLinks(self.package.cmake).all:
            library, _, name = link.word.text.partition("::")
            is_sure = link.word.is_known and not link.word.maybe and not link.call.maybe and not link.package
            if not is_sure or not is_component(library, name) or link.word.text in seen | ALWAYS:
                continue
            is_own = self.package.cmake.target(link.word.text) is not None
            asked = self.asked(library) if library != "OpenCV" and self.is_found(library) and not is_own else None
            if asked is not None and name not in asked:
                seen.add(link.word.text)
                stranger = next((each for each in self.others if not each.startswith(library)), "")
                yield LostComponent(library, name, link.word.path, link.word.span, link.word.text, stranger)

    def called(self) -> Iterator[LostComponent]:
        """Yield those of OpenCV that compiled sources call, where its parts are linked by its variables alone."""
        asked = self.asked("OpenCV") if self.is_found("OpenCV") else None
        gifts = [LITTLE.get(each) for each in self.others if each != "OpenCV"]
        lists_all = any(e.name == "OpenCV" and not e.components for e in self.package.cmake.packages)
        if not asked or None in gifts or lists_all:
            return
        there = asked | {name for gift in gifts for name in gift or ()}
        texts = [file.source.text for file in self.package.cmake.files]
        compiled = own_compiled(self.package.cmake, self.sources) or set()
        for source in self.sources:
            for found in OF_CV.finditer(code_text(source.source.text)) if source.path in compiled else ():
                part = component_of_call(found[1])
                if part and part not in there and not any(part in text for text in texts):
                    there = there | {part}
                    yield LostComponent("OpenCV", part, source.path, Span(*found.span()), found[0], "")

    @cached_property
    def others(self) -> tuple[str, ...]:
        """The packages that are found, or may be, and may find a library for themselves."""
        names = [each.name for each in self.package.cmake.packages]
        if any(call.name in SEARCHES for call in self.package.cmake.calls):
            names += [e.name for e in self.package.manifest.dependencies if not KEY.match(e.name)]
        return tuple(name for name in dict.fromkeys(names) if not PLAIN.fullmatch(name))
