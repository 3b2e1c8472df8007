"""Packages that a page, a script or a comment leaves out of a build on purpose, or calls optional."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cached_property
from typing import TYPE_CHECKING

from ...files import PackageFiles
from ...light_dataclasses import dataclass
from .declared_dependencies import DeclaredDependencies

if TYPE_CHECKING:
    from .optional_parts import OptionalParts


@dataclass(frozen=True)
class LeftOutPackages:
    declared: DeclaredDependencies
    files: PackageFiles

    def why(self, name: str, paths: Iterable[str]) -> str:
        """Return why a package is left out, as the end of a message; "" where nothing says so.

        A page or a comment may call it optional. One of the workspace may be left out of a build that a page describes,
        which is seen from the names of the files that need it (`paths`).
        """
        if self.declared.workspace.named(name) is None:
            return self.optional.why([name], dict.fromkeys(paths))
        from .partial_builds import LEFT_OUT, is_built_without  # most declare their neighbours

        own = self.declared.facts.name
        return LEFT_OUT if is_built_without(self.files, own, name, {*paths}) else ""

    @cached_property
    def optional(self) -> OptionalParts:
        from .optional_parts import OptionalParts  # most packages are declared

        return OptionalParts(self.files)
