"""Components of Boost that an exported target links, and that users of it do not find (CMK113)."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.cmake.values import UNKNOWN, Word
from ...light_dataclasses import dataclass
from ...package.cmake.target_links import TargetLink, TargetLinks
from ...ros.components import ALWAYS, PLAIN, is_component
from .missing_export_dependencies import ExportedDependencies

BOOST = "Boost"
LIBRARIES = "${Boost_LIBRARIES}"


@dataclass(frozen=True, slots=True)
class UnaskedComponent:
    package: str
    name: str
    """The target of the component."""
    target: str
    word: Word
    is_certain: bool
    """Whether the target is linked by its name, and nothing else that is exported may ask for it."""


def unexported_components(exported: ExportedDependencies) -> Iterator[UnaskedComponent]:
    """Yield the first component that an exported target links, where Boost is exported without components.

    A file of CONFIG_EXTRAS may ask for it.
    """
    package, exports = exported.headers.package, exported.exports
    cmake = package.cmake
    extras = any("CONFIG_EXTRAS" in text for call in cmake.calls for text in call.texts)
    unclear = not cmake.is_complete or cmake.includes_unknown_files or UNKNOWN in exports.packages or extras
    if unclear or not package.is_ament or BOOST not in exports.packages:
        return
    is_alone = all(PLAIN.fullmatch(each) or each == BOOST for each in exports.packages)
    for link in TargetLinks(cmake).all:
        passed = link.is_public and link.target in exports.targets and not link.call.maybe and not link.word.maybe
        target = cmake.target(link.target)
        name = component_of(exported, link) if passed and target is not None and target.is_library else ""
        if name:
            is_named = link.word.text.startswith(f"{BOOST}::")
            yield UnaskedComponent(BOOST, name, link.target, link.word, is_alone and is_named)
            return


def component_of(exported: ExportedDependencies, link: TargetLink) -> str:
    """Return the target of a component that a link names, or that Boost's variable has; "" where there is none."""
    cmake = exported.headers.package.cmake
    library, _, name = link.word.text.partition("::")
    if library == BOOST and name:
        return link.word.text if is_component(BOOST, name) and name not in ALWAYS else ""
    if link.word.text != BOOST if link.package else cmake.source_text(link.word).strip('"') != LIBRARIES:
        return ""
    names = [word.text for each in cmake.packages if each.name == BOOST for word in each.components if word.is_known]
    return next((f"{BOOST}::{name}" for name in names if is_component(BOOST, name)), "")
