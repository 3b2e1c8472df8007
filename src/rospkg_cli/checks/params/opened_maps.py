"""Whether something is shown to open a map: it names the file, or starts what reads maps and names their folder."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from functools import cached_property

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ..opening_places import OpeningPlaces, whole
from ..repository.pages_and_scripts import pages_and_scripts

READS_MAPS = regex(r"map_server|yaml_filename|nav2_bringup|bringup_launch|localization_launch|navigation2?[._]launch")
"""What starts a map server, itself or by nav2, to which the user gives one of the maps of a folder."""
LOADS_MAPS = regex(r"LoadMap|/load_map\b|map_url|[\"']image[\"']")
"""What a program has that hands a map on to such a server, or asks for the picture of the map itself."""
PARSES = regex(r"\bYAML\s*\(|\byaml\.load|\b(?:safe|full|unsafe)_load\s*\(|\bYAML::Load")
PICTURE = regex(r"[\w-]\.(?:pgm|png|bmp|jpg)[\"']")
PROGRAM = regex(r"(?m)^(?:import |from [\w.]+ import |[ \t]*#[ \t]*include\b)")
OF_LAUNCH = "LaunchDescription"


@dataclass(frozen=True)
class OpenedMaps:
    opening: OpeningPlaces

    def has(self, path: str) -> bool:
        """Return whether code, a launch file, YAML, a page or a script opens a map."""
        return any(True for _ in self.of(path))

    def takes_picture(self, path: str) -> bool:
        """Return whether one of those that open a map may load its picture, and not only other keys of it."""
        return any(may_take_picture(text) for text in self.of(path))

    def of(self, path: str) -> Iterator[str]:
        """Yield the texts that open a map, by its name or as one of a folder.

        Of the folder alone another file may be read, as a picture; a name that several maps have needs the folder.
        """
        folder, name = posixpath.split(path)
        named, last = whole(name), posixpath.basename(folder)
        in_folder = re.compile(rf"(?<![\w.-]){re.escape(last)}[\"'/]") if last else None
        again = [each for each in self.opening.files.paths if each.endswith(f"/{name}") and each != path]
        for own, text in self.texts:
            is_in_folder = in_folder is not None and in_folder.search(text) is not None
            is_named = named.search(text) is not None and (is_in_folder or not again)
            if own != path and (is_named or (is_in_folder and READS_MAPS.search(text))):
                yield text

    @cached_property
    def texts(self) -> tuple[tuple[str, str], ...]:
        return (*self.opening.texts, *(("", text) for text in pages_and_scripts(self.opening.files)))


def may_take_picture(text: str) -> bool:
    """Return whether a text may have the picture of a map loaded: all do, but for a program without a map server that
    names a picture itself, or parses YAML and never asks for an `image`.
    """
    if PROGRAM.search(text) is None or OF_LAUNCH in text or READS_MAPS.search(text) or LOADS_MAPS.search(text):
        return True
    return PICTURE.search(text) is None and PARSES.search(text) is None
