"""Files that a robot description refers to, and that are not where it looks for them."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from ...files import PackageFiles
from ...lazy_regex import regex
from ...light_dataclasses import dataclass, replace
from ...package.package_facts import PackageFacts
from ...package.urdf.robot_file import ResourceReference, RobotFile
from ...suggest import nearest
from .emptied_folders import emptied_folders
from .missing_resource import MissingResource, State
from .model_files import missing_of_models
from .share_resources import ShareResources

LOADS = regex(r"\bload_yaml\(\s*[\"']$")
REACH = 40


@dataclass(frozen=True)
class MissingFiles:
    robot: RobotFile
    files: PackageFiles
    resources: ShareResources

    def missing(self) -> Iterator[MissingResource]:
        """Yield each file, or folder, that is referenced and does not exist, once, as far as that is known."""
        found: dict[tuple[str, str, State], list[MissingResource]] = {}
        every = list(self.every_missing())
        alone = ((each.package, each.path) for each in every if not (each.is_include or each.folder or each.is_model))
        emptied = emptied_folders(((each.package, each.path or "") for each in self.robot.references), alone)
        for each in every:
            inner = posixpath.dirname(each.path)
            is_one = each.state != "absent" or (each.package, inner) in emptied
            place = each.folder or (inner if is_one else "")
            found.setdefault((each.package, place or each.path, each.state), []).append(each)
        for first, *others in found.values():
            yield replace(first, others=tuple(others))

    def every_missing(self) -> Iterator[MissingResource]:
        """Yield each reference to a missing file: into share directories, next to the robot, and into models."""
        resources = self.resources
        for reference in self.robot.references:
            facts = resources.facts_of(reference.package)
            path = reference.path
            if facts is None or not path or path.startswith("..") or resources.is_expected(facts, path):
                continue
            state = resources.state(facts, path)
            near = resources.goes_to(path) if state == "elsewhere" else self.suggestion(facts, path)
            is_certain = facts.knows("share_files") or near
            if state is not None and is_certain and not resources.is_reported(facts, path, state):
                folder = resources.missing_folder(facts, path) if state == "absent" else ""
                better = near if not folder or near is None else matching_folder(folder, path, near)
                is_read = reference.use == "include" or self.is_loaded(reference)
                yield MissingResource(reference.path_span, facts.name, path, state, is_read, better, folder)
        for local in self.robot.includes:
            is_outside = local.path.startswith("..")
            if not (is_outside or self.files.exists(local.path) or resources.is_made(local.path)):
                similar = nearest(posixpath.basename(local.path), self.neighbours(local.path))
                yield MissingResource(local.span, resources.package.name, local.path, "absent", True, similar)
        yield from missing_of_models(self.robot, self.files, resources.workspace)

    def suggestion(self, facts: PackageFacts, path: str) -> str | None:
        """Return the likely path: a near one, or the file of that name next to this robot."""
        if near := self.resources.closest(facts, path):
            return near
        sibling = posixpath.join(posixpath.dirname(self.robot.path), posixpath.basename(path))
        return sibling if facts is self.resources.package and self.files.exists(sibling) else None

    def is_loaded(self, reference: ResourceReference) -> bool:
        """Return whether an expression of xacro reads a file (`load_yaml`): xacro stops if the file is missing."""
        text = self.robot.source.text
        return LOADS.search(text, max(0, reference.span.start - REACH), reference.span.start) is not None

    def neighbours(self, path: str) -> list[str]:
        """Return the names of the files in the folder of a path."""
        folder = posixpath.dirname(path)
        return [posixpath.basename(each) for each in self.files.paths if posixpath.dirname(each) == folder]


def matching_folder(folder: str, path: str, near: str) -> str:
    """Return the folder of the near path that corresponds to the missing one, where both paths end the same."""
    rest = path.removeprefix(folder)
    return near.removesuffix(rest) if near.endswith(rest) else posixpath.dirname(near)
