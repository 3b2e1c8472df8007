"""Names that package.xml declares in a wrong way, which other rules report: slips, unknown tags, names on PyPI."""

from __future__ import annotations

from functools import cached_property

from ...light_dataclasses import dataclass
from ...package.manifest import Manifest
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from ...ros.aliases import key_for_pip, successors
from ...ros.distros import Targets
from ...ros.manifest import CONDITIONAL_TAGS, DEPENDENCY_TAGS
from ...ros.names import NameKind
from ...suggest import near_names
from .intended_names import key_of_cmake_name


@dataclass(frozen=True)
class MisnamedDependencies:
    manifest: Manifest
    facts: PackageFacts
    workspace: Workspace

    def has(self, name: str) -> bool:
        """Return whether package.xml declares a name in a wrong way, so that it is not reported as undeclared.

        The name may be the package itself in another spelling or by its own module, be in an unknown tag, in a tag
        with several names, or be the ROS 2 successor, the key or the right spelling of a declared name.
        """
        if normalized(name) == normalized(self.facts.name) or name in self.in_unknown_tags or self.is_own_folder(name):
            return True
        if name in self.own_modules and self.workspace.named(name) is None:
            return True
        return name in self.written_otherwise or bool(self.unknown_names and near_names(name, self.unknown_names))

    def is_own_folder(self, name: str) -> bool:
        """Return whether a name is that of the package's folder, and the package's own name nearly the same."""
        is_folder = name == self.facts.folder.rpartition("/")[2] and self.workspace.named(name) is None
        return is_folder and bool(near_names(self.facts.name, [name]))

    @cached_property
    def own_modules(self) -> frozenset[str]:
        """The top level Python modules of the package."""
        return frozenset(module.partition(".")[0] for module in self.facts.modules)

    @cached_property
    def in_unknown_tags(self) -> frozenset[str]:
        """The texts of tags that are misspelt tags of dependencies: `<exec_depends>`; group_depend is none."""
        unknown = (each for each in self.manifest.root.children if each.tag not in CONDITIONAL_TAGS)
        return frozenset(e.text for e in unknown if "depend" in e.tag.lower() or near_names(e.tag, DEPENDENCY_TAGS))

    @cached_property
    def unknown_names(self) -> frozenset[str]:
        """The declared names that are no package and no key, without those under a condition for ROS 1 alone."""
        known = (NameKind.PACKAGE, NameKind.KEY)
        active = (d for d in self.manifest.dependencies if d.active(Targets()))
        return frozenset(d.name for d in active if self.workspace.kind_of(d.name) not in known)

    @cached_property
    def written_otherwise(self) -> frozenset[str]:
        """The right names for declared ones that are of PyPI, CMake or ROS 1, or that share one tag."""
        keys = (key for name in self.unknown_names if (key := key_of_cmake_name(name) or key_for_pip(name)) is not None)
        parts = (words for name in self.unknown_names if len(words := name.replace(",", " ").split()) > 1)
        active = (d.name for d in self.manifest.dependencies if d.active(Targets()))
        old = (successors(name) or () for name in active if self.workspace.named(name) is None)
        return frozenset([*keys, *(each for words in (*parts, *old) for each in words)])


def normalized(name: str) -> str:
    return name.replace("-", "_").lower()
