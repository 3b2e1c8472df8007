"""A dependency in package.xml, under the tag that fits."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal

from ..change import ChangeError
from ..edits.manifest import add_dependency, remove_element
from ..languages.xml.elements import Element
from ..lazy_regex import regex
from ..light_dataclasses import dataclass
from ..package.manifest import Manifest
from ..package.package import Package
from ..ros.manifest import BUILDS, NEW_IN, RELATIONS, RUNS
from .named import is_needed
from .part import Operations

Need = Literal["all", "exec", "test", "buildtool"]
"""When it is needed: to build and to run, to run, for tests, or as a tool of the build."""

TAGS: dict[Need, str] = {"all": "depend", "exec": "exec_depend", "test": "test_depend", "buildtool": "buildtool_depend"}


@dataclass(frozen=True)
class AddedDependency:
    name: str
    need: Need = "all"
    tag: str = ""
    """The tag that was asked for; "" for the one that fits."""
    force: bool = False
    """Whether it is removed even where something names it."""

    def add(self, package: Package) -> Operations:
        """Return the new element, nothing where what is declared is enough; raises ChangeError without a manifest."""
        manifest = manifest_of(package)
        if self.name == manifest.name or (not self.tag and self.is_met(manifest)):
            return ()
        tag = self.tag or self.missing_tag(manifest)
        if manifest.depends_on(self.name, (tag,)):
            return ()
        if manifest.format == 1 and tag in NEW_IN[2]:
            tags = {"depend": ("build_depend", "run_depend"), "exec_depend": ("run_depend",)}.get(tag)
            if tags is None:
                raise ChangeError(f"package.xml has format 1, which has no <{tag}>; set format 3 first")
            return tuple(add_dependency(manifest, each, self.name) for each in tags)
        return (add_dependency(manifest, tag, self.name),)

    def is_met(self, manifest: Manifest) -> bool:
        tags = {each.tag for each in manifest.dependencies if each.name == self.name}
        builds, runs = bool(tags & BUILDS), bool(tags & RUNS)
        match self.need:
            case "all":
                return builds and runs
            case "exec":
                return runs
            case "buildtool":
                return builds
            case "test":
                return bool(tags.difference(RELATIONS))

    def missing_tag(self, manifest: Manifest) -> str:
        """Return the tag for what is not declared yet."""
        if self.need != "all":
            return TAGS[self.need]
        tags = {each.tag for each in manifest.dependencies if each.name == self.name}
        return "exec_depend" if tags & BUILDS else "build_depend" if tags & RUNS else "depend"

    def remove(self, package: Package) -> Iterator[Operations]:
        """Yield the removal of the element, nothing where a file of the package needs it.

        Where Python alone needs what C++ was compiled with, that of the build goes.
        """
        manifest = manifest_of(package)
        if self.force or not is_needed(package, self.name):
            wanted = self.tag or TAGS[self.need]
            tags = {wanted} | ({"build_depend", "run_depend"} if manifest.format == 1 else set())
            found = self.elements(manifest, tags)
            if not found and self.is_of_both:
                found = self.elements(manifest, {"build_depend", "exec_depend"})
        elif self.is_of_both and not is_needed(package, self.name, ".py") and self.elements(manifest, {"exec_depend"}):
            found = self.elements(manifest, {"build_depend"})
        else:
            return
        if found:
            yield tuple(remove_element(manifest, element) for element in found)

    @property
    def is_of_both(self) -> bool:
        """Whether it is for the build and for the run, and the user named no tag."""
        return self.need == "all" and not self.tag

    def elements(self, manifest: Manifest, tags: set[str]) -> list[Element]:
        return [each.element for each in manifest.dependencies if each.name == self.name and each.tag in tags]


NAME = regex(r"[A-Za-z][A-Za-z0-9_-]*")
"""What may stand in code as the name of a package: the schemas of all formats, and upper case."""


def manifest_of(package: Package) -> Manifest:
    """Return package.xml; raises ChangeError where it can't be read, or has a name that no code can hold."""
    manifest = package.parts(Manifest).only
    if manifest is None or not manifest.name:
        raise ChangeError("package.xml can't be read; `rospkg lint` says why")
    if not NAME.fullmatch(manifest.name):
        raise ChangeError(f"`{manifest.name}` is no name for a package; `rospkg lint` says why")
    return manifest
