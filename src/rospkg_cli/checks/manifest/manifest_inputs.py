"""Inputs of manifest rules: a manifest together with other parts of its package."""

from __future__ import annotations

from functools import cached_property

from ...files import PackageFiles
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.file_role import is_set_aside
from ...package.install_table import InstallTable
from ...package.launch.live_text import live_text
from ...package.manifest import Manifest
from ...package.package_facts import PackageFacts
from ...package.rule_settings import RuleSettings
from ...ros.distros import Targets
from ...ros.interfaces import KINDS
from ...ros.manifest import BUILD_TYPES, OTHER_BUILD_TYPES
from ..repository.released import Release
from .schema_tests import SchemaTests

GENERATES = regex(r"(?i)rosidl|generate\w*_(?:interfaces|messages)|_interfaces\s*\(")
"""Commands that generate interfaces, and macros around them by their usual names."""


@dataclass(frozen=True)
class ManifestForTargets:
    manifest: Manifest
    targets: Targets


@dataclass(frozen=True)
class NamedManifest:
    """A manifest, with what refuses a name that colcon accepts."""

    package: ManifestAndFiles
    tests: SchemaTests
    release: Release

    @property
    def is_met(self) -> bool:
        """Whether rosidl, a test with the schema or a release would refuse an invalid name."""
        return self.package.generates_interfaces or self.tests.is_tested or self.release.is_made


@dataclass(frozen=True)
class ManifestInFolder:
    manifest: Manifest
    facts: PackageFacts


@dataclass(frozen=True)
class ManifestAndFiles:
    manifest: Manifest
    files: PackageFiles
    targets: Targets
    settings: RuleSettings

    @cached_property
    def interface_files(self) -> tuple[str, ...]:
        """The .msg, .srv and .action files in the folders of those names."""
        return tuple(
            path
            for kind in KINDS
            for path in self.files.below(kind)
            if path.endswith("." + kind) and path.count("/") == 1
        )

    @cached_property
    def generates_interfaces(self) -> bool:
        """Whether it has interface files, and its CMake files name a command that generates code from them."""
        built = (path for path in self.files.paths if path.endswith(("CMakeLists.txt", ".cmake")))
        return bool(self.interface_files) and any(GENERATES.search(live_text(self.files, path)) for path in built)

    @property
    def is_set_aside(self) -> bool:
        """Whether the package is in a folder for unused code, by its name: `old/`, `backup/`."""
        return is_set_aside(f"{self.files.folder}/")

    @property
    def known_build_types(self) -> frozenset[str]:
        return self.settings.build_types.union(BUILD_TYPES, OTHER_BUILD_TYPES)


@dataclass(frozen=True)
class ManifestAndInstalls:
    manifest: Manifest
    files: PackageFiles
    table: InstallTable | None
    targets: Targets

    def is_installed(self, path: str) -> bool | None:
        """Return whether a file is installed in share/<name> at this path; None where that is unknown."""
        if self.table is None or not self.table.knows("share"):
            return None
        return any(path == below for below, _ in self.table.below(f"share/{self.manifest.name}"))
