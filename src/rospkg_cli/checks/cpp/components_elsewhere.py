"""Components that CMake registers for a library, and whose class is in another one (CMK108)."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.cmake.evaluated_command import path_in_package
from ...languages.cmake.file import assigned_names
from ...languages.cmake.targets import Target
from ...languages.cmake.values import UNKNOWN, Word
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.cmake.components import Component
from ...package.cmake.target_links import TargetLinks
from ..cmake.component_registration import ComponentRegistration
from ..cmake.registered_classes import RegisteredClass, has_own_macro
from ..depends.header_inclusions import Inclusions


@dataclass(frozen=True)
class ComponentElsewhere:
    component: Component
    found: RegisteredClass
    is_loaded_by_another: bool
    """Whether it is registered of a second library as well, which may have it."""

    @property
    def sentence(self) -> str:
        plugin, target = self.component.plugin.text, self.component.target.text
        fault = f"`{plugin}` is in `{self.found.path}`, which `{target}` is not made of"
        return f"{fault}: it can't be loaded from that library; name the library that has it, or another class"


def components_elsewhere(registration: ComponentRegistration) -> Iterator[ComponentElsewhere]:
    """Yield each such component; only where all sources of the library and of what it links are known."""
    cmake = registration.package.cmake
    if (
        has_own_macro(registration.sources)
        or registration.generated
        or cmake.reads_unknown_files
        or not cmake.is_complete
    ):
        return
    names = [each.plugin.text for each in registration.sure()]
    for component in registration.sure():
        places = [each for each in registration.in_sources if each.name == component.plugin.text]
        reached = reached_by(registration, component.target.text)
        if places and reached is not None and not any(each.path in reached for each in places):
            yield ComponentElsewhere(component, places[0], names.count(component.plugin.text) > 1)


def reached_by(registration: ComponentRegistration, name: str) -> set[str] | None:
    """Return the files that a library is made of, with what it is linked with; None where that is not known."""
    cmake = registration.package.cmake
    links, found, waiting = TargetLinks(cmake), set[str](), [name]
    seen: set[str] = set()
    while waiting:
        name = waiting.pop()
        made = [each for each in cmake.targets if each.name == name]
        sources = sources_of_one(made, registration)
        if sources is None or any(is_own_variable(each.word, cmake) for each in links.of(name)):
            return None
        seen.add(name)
        found |= sources
        own = (links.own(each.word.text) for each in links.of(name))
        waiting += [each.name for each in own if each is not None and each.name not in seen]
    return Inclusions({file.path: file for file in registration.sources}).reached(found)


def is_own_variable(word: Word, cmake: CMake) -> bool:
    """Return whether a word is not known, and not of variables of other packages alone."""
    if UNKNOWN not in word.text:
        return False
    text = cmake.source_text(word)
    return "$" not in text or any(name in text for file in cmake.files for name in assigned_names(file))


def sources_of_one(made: list[Target], registration: ComponentRegistration) -> set[str] | None:
    cmake, files = registration.package.cmake, {file.path for file in registration.sources}
    if len(made) != 1 or made[0].folder is not None or made[0].call.maybe:
        return None
    added = any(call.texts[:1] == (made[0].name,) for call in cmake.named("target_sources"))
    paths = {path_in_package(word.text, made[0].call.folder) for word in made[0].sources if word.is_known}
    is_known = all(word.is_known for word in made[0].sources) and None not in paths
    return {path for path in paths if path in files} if is_known and not added else None
