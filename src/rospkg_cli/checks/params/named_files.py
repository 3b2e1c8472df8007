"""PRM010: files that parameter files and maps name, and that are not there."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING, Annotated

from ...files import PackageFiles
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.file_role import is_set_aside, role_of
from ...package.launch.launch_file import LaunchFile
from ...package.package_facts import PackageFacts
from ...package.params.parameter_file import ParameterFile
from ...package.workspace import Workspace
from ...source import Span
from ...unreadable import READABLE
from ..fault import Fault, softer_advice
from ..opening_places import OpeningPlaces
from ..paths.closest_path import closest_path
from ..repository.left_to_people import files_of, why_left
from ..yaml_elsewhere import is_named_yaml
from .launch_overrides import is_overridden
from .map_images import MAP, image_faults, why_replaced
from .path_readers import PathReaders

if TYPE_CHECKING:
    from .opened_maps import OpenedMaps

UNOPENED = "as soon as something here opens this file"
UNTAKEN = "and what names the map here reads only other keys of it"
UNREAD = "and neither code here nor a well-known node is shown to read it by this key"
PARAMETERS = "ros__parameters"
SHARED = regex(
    r"^[ \t]*([\w.]+)[ \t]*:[ \t]*[\"']?(?:\$\(find-pkg-share[ \t]+(\w+)\)|package://(\w+))(/[\w./-]+\.\w+)[\"']?"
    r"[ \t]*(?:#.*)?\r?$",
    re.MULTILINE,
)


@dataclass(frozen=True)
class NamedFiles:
    files: PackageFiles
    package: PackageFacts
    workspace: Workspace
    opening: OpeningPlaces
    launches: Annotated[tuple[LaunchFile, ...], READABLE] = ()
    parameters: Annotated[tuple[ParameterFile, ...], READABLE] = ()

    def faults(self) -> Iterator[tuple[str, Fault]]:
        """Yield what is missing; nothing where a package of tests has a file that nothing names."""
        for path in self.files.paths:
            if path.endswith((".yaml", ".yml")) and role_of(path) not in ("test", "aside") and not is_set_aside(path):
                text = self.files.readable_text(path)
                found = (
                    image_faults(self.files, self.package, path, text)
                    if MAP.search(text)
                    else self.of_parameters(path, text)
                )
                for fault in found:
                    why = "" if fault.level == "info" else self.why_unmet(path, text, fault)
                    if not why:
                        yield path, fault
                    elif not self.package.name.endswith(("_test", "_tests")):
                        yield path, softer_advice(fault, "info", why)

    def of_parameters(self, path: str, text: str) -> Iterator[Fault]:
        """Yield the files below a share directory; launch may set what it names, so that is an info."""
        for found in SHARED.finditer(text) if PARAMETERS in text else ():
            name, named = found[2] or found[3], posixpath.normpath(found[4].lstrip("/"))
            facts = self.package if name == self.package.name else self.workspace.named(name)
            if facts is None or not self.lacks(facts, named):
                continue
            from .made_files import why_made, why_written  # the same

            near = closest_path(named, facts.share_files)
            hint = f"did you mean `{near}`?" if near else "add it, or correct the path"
            message = f"`{name}` has no file `{named}`: what opens it finds nothing there"
            is_set = any(found[1].rpartition(".")[2] in each for each in self.starting)
            place = Span(*found.span(2 if found[2] else 3))
            is_set = is_set or is_overridden(path, place, self.parameters, self.launches)
            why = "where the launch file gives no other" if is_set else ""
            why = why or why_written(found[1]) or why_replaced(text, place.start)
            why = why or (self.left(facts, named) or why_made(named, facts.share_files) if not near else "")
            fault = Fault(Span(found.start(4) + 1, found.end(4)), f"{message}; {hint}")
            yield softer_advice(fault, "info", why) if why else fault

    def left(self, facts: PackageFacts, path: str) -> str:
        """Return why a file of a package is left to people; "" where it is not."""
        return why_left(files_of(self.files, facts, own=facts is self.package), path)

    @cached_property
    def starting(self) -> tuple[str, ...]:
        """The texts of the launch files of the package."""
        return tuple(self.files.readable_text(path) for path in self.files.paths if role_of(path) == "launch")

    def lacks(self, facts: PackageFacts, path: str) -> bool:
        """Return whether a package certainly has no such file; one that it has and does not install is not lacking."""
        if not facts.knows("share_files") or facts.may_write(path) or path in facts.run_time_files:
            return False
        if path in facts.share_files or path in facts.uninstalled:
            return False
        if facts is self.package:
            return not (self.files.is_there(path) or self.files.absent.is_expected(path))
        return not self.files.absent_in(facts.folder).is_ignored(path)

    def why_unmet(self, path: str, text: str, fault: Fault) -> str:
        """Return why nothing is shown to open a map, or to read the parameter that names a file; "" where one is."""
        is_map = MAP.search(text) is not None
        if not self.is_used(path) or (is_map and not self.maps.has(path)):
            return UNOPENED
        if is_map and not self.maps.takes_picture(path):
            return UNTAKEN
        is_read = is_map or PathReaders(self.files, self.workspace, self.parameters).has(path, fault.span, text)
        return "" if is_read else UNREAD

    @cached_property
    def maps(self) -> OpenedMaps:
        from .opened_maps import OpenedMaps  # few packages miss a file

        return OpenedMaps(self.opening)

    def is_used(self, path: str) -> bool:
        """Return whether a YAML file is not left out of what is installed, and something may name it."""
        is_left = self.package.knows("share_files") and path in self.package.uninstalled
        return not is_left and is_named_yaml(path, self.package, self.workspace)
