"""Rule input: the files that robots of a package include, always or by a condition, and the arguments they read."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cached_property

from ...files import PackageFiles
from ...light_dataclasses import dataclass
from ...package.file_role import role_of
from ...package.package_facts import PackageFacts
from ...package.urdf.expansion.expander import Expander
from ...package.urdf.expansion.expansion import Expansion
from ...package.urdf.expansion.library import XacroLibrary
from ...package.workspace import Workspace
from .enclosing_elements import CONDITIONS, ancestors
from .off_conditions import OffConditions
from .xacro_calls import XacroCalls

ROBOTS = (".xacro", ".urdf")


@dataclass(frozen=True)
class ReachedFiles:
    files: PackageFiles
    package: PackageFacts
    workspace: Workspace
    calls: XacroCalls
    off: OffConditions

    def is_never(self, path: str) -> bool:
        """Return whether each include of a file is under a condition that nothing here makes true."""
        if not self.is_off(path):
            return False
        name = path.rpartition("/")[2]
        found = [
            any(each.tag in CONDITIONS and self.off.has(each) for each in ancestors(document.root, element.span))
            for document in self.library.documents.values()
            if document is not None
            for element in document.root.walk()
            if element.tag == "xacro:include" and (element.get("filename") or "").rpartition("/")[2] == name
        ]
        return bool(found) and all(found)

    def is_off(self, path: str) -> bool:
        """Return whether robots include a file, and none does as long as each argument has its default."""
        every = any(path in each.reached for each in self.expansions)
        return every and not any(path in each.certain for each in self.by_default)

    def reads(self, path: str, argument: str) -> bool:
        """Return whether anything may read an argument of a file; a file that is included and not here may."""
        reaching = [each for each in self.by_default if path in each.reached]
        if not any(path in each.reached for each in self.expansions) or any(each.lacks_files for each in reaching):
            return True
        read = re.compile(rf"\barg\s+{re.escape(argument)}\b|\barg\(\s*[\"']{re.escape(argument)}[\"']")
        others = (document.source.text for document in self.library.documents.values() if document is not None)
        return any(map(read.search, (*self.calls.includes.texts, *others)))

    @cached_property
    def library(self) -> XacroLibrary:
        return XacroLibrary(self.files, self.package.name, self.workspace)

    @cached_property
    def expansions(self) -> tuple[Expansion, ...]:
        """The robots of the package, with arguments of any value."""
        return tuple(self.expanded(with_defaults=False))

    @cached_property
    def by_default(self) -> tuple[Expansion, ...]:
        return tuple(self.expanded(with_defaults=True))

    def expanded(self, *, with_defaults: bool) -> Iterator[Expansion]:
        for path in self.files.paths:
            document = self.library.read(path) if path.endswith(ROBOTS) and role_of(path) in ("run", "launch") else None
            if document is not None and document.root.tag == "robot" and self.calls.includes.is_top(document):
                yield Expander(self.library, with_defaults=with_defaults).run(document)
