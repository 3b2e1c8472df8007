"""Libraries that `ament_target_dependencies()` is given and of which it links nothing (CMK121)."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...languages.cmake.evaluated_command import path_in_package
from ...languages.cpp.file import IncludeDirective
from ...light_dataclasses import dataclass
from ...package.cmake.target_links import TargetLink
from .unlinked_includes import UnlinkedIncludes

VARIABLES = {
    "octomap": ("OCTOMAP_INCLUDE_DIRS", "OCTOMAP_LIBRARIES"),
    "ompl": ("OMPL_INCLUDE_DIRS", "OMPL_LIBRARIES"),
    "yaml-cpp": ("YAML_CPP_INCLUDE_DIR", "YAML_CPP_LIBRARIES"),
}
"""Libraries whose variables do not begin with their names; the command reads `octomap_LIBRARIES` alone."""


@dataclass(frozen=True, slots=True)
class IdleLink:
    link: TargetLink
    include: IncludeDirective
    path: str
    """The file with the include."""
    variables: tuple[str, str]


def idle_links(unlinked: UnlinkedIncludes) -> Iterator[IdleLink]:
    """Yield each library once that a target includes, is given, and gets in no other way: nothing else in CMake has a
    word of its variables or targets."""
    cmake, seen = unlinked.includes.cmake, set[str]()
    if not cmake.is_complete or cmake.includes_unknown_files:
        return
    texts = [file.source.text for file in cmake.files]
    for link in unlinked.linked.links.all:
        name = link.word.text
        variables = VARIABLES.get(name) if link.package and name not in seen and not link.call.maybe else None
        target = cmake.target(link.target)
        if variables is None or target is None or link.call.testing:
            continue
        linked = any(each.word.text == name and not each.package for each in unlinked.linked.links.all)
        prefix = variables[1].removesuffix("_LIBRARIES")
        other = re.compile(
            rf"^[^#\n]*(?:{prefix}_|{re.escape(name)}::|(?<!\w)-l{re.escape(name)})", re.MULTILINE | re.I
        )
        if linked or any(map(other.search, texts)):
            continue
        paths = {path_in_package(word.text, target.call.folder) for word in target.sources}
        for path in sorted(unlinked.opened.inclusions.reached(path for path in paths if path in unlinked.opened.files)):
            found = next((e for e in unlinked.opened.files[path].includes if e.path.startswith(f"{name}/")), None)
            if found is not None:
                seen.add(name)
                yield IdleLink(link, found, path, variables)
                break
