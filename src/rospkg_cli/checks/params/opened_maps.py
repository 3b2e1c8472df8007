"""Whether something is shown to open a map: it names the file, or starts what reads maps and names their folder."""

from __future__ import annotations

import posixpath
import re
from functools import cached_property

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ..opening_places import OpeningPlaces, whole
from ..pages_and_scripts import pages_and_scripts

READS_MAPS = regex(r"map_server|yaml_filename|nav2_bringup|bringup_launch|localization_launch|navigation2?[._]launch")
"""What a text has that starts a map server, itself or by nav2, which people give one of the maps beside each other."""


@dataclass(frozen=True)
class OpenedMaps:
    opening: OpeningPlaces

    def has(self, path: str) -> bool:
        """Return whether code, a launch file, YAML, a page or a script opens a map, by its name or as one of a folder.

        Of the folder alone another file may be read, as a picture; a name that several maps have needs the folder.
        """
        folder, name = posixpath.split(path)
        named, last = whole(name), posixpath.basename(folder)
        beside = re.compile(rf"(?<![\w.-]){re.escape(last)}[\"'/]") if last else None
        again = [each for each in self.opening.files.paths if each.endswith(f"/{name}") and each != path]
        for own, text in self.texts:
            is_beside = beside is not None and beside.search(text) is not None
            if own != path and is_beside and READS_MAPS.search(text):
                return True
            if own != path and named.search(text) and (is_beside or not again):
                return True
        return False

    @cached_property
    def texts(self) -> tuple[tuple[str, str], ...]:
        return (*self.opening.texts, *(("", text) for text in pages_and_scripts(self.opening.files)))
