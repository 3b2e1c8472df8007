"""Whether an unknown name may be a key of a list that a repository adds to rosdep's, so that rosdep finds it there."""

from __future__ import annotations

import re

from ...files import PackageFiles
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.dependency import Dependency
from ...source import Span
from ..repository.container_files import files_called
from .declared_dependencies import DeclaredDependencies
from .skipped_keys import texts_on_dependencies
from .unavailable_on_target import NO_PACKAGE
from .wrong_names import wrong_name

HERE = "; a list of rosdep keys here has it"
ADDED = "; a page or a script here adds a list to rosdep's, which may have it"
SHARED = "; the packages here need further keys that rosdep does not know: a list of their own may have it"
ENOUGH = 2
"""With so many unknown keys that are no misspelt names, there is probably a list that has them."""
LIST = regex(r"(?i)(?:^|/)[^/]*rosdep[^/]*(?:/.*)?\.ya?ml$")
ADDS = regex(
    r"(?:>|\b(?:tee|cp|mv|ln|install|curl|wget|COPY|ADD)\b[^\n|;&>]*[ \t\"'=])[ \t]*[\"']?[^\s\"'>]*"
    r"rosdep/sources\.list\.d\b(?!/20-default\.list)|\bROSDEP_SOURCE_PATH[ \t]*="
)
"""What writes into the folder of rosdep's lists; the default list there is what `rosdep init` writes, or a mirror."""


@dataclass(frozen=True)
class OwnRosdepLists:
    declared: DeclaredDependencies

    def may_have(self, name: str) -> str:
        """Return why a name may be a key of such a list, as the end of a sentence; "" where nothing says so."""
        files = self.declared.release.files
        if is_listed(name, files):
            return HERE
        if any("rosdep" in text.lower() and ADDS.search(text) for text in texts_on_dependencies(files)):
            return ADDED
        return SHARED if NO_PACKAGE.fullmatch(name) and self.has_strange_keys(name) else ""

    def has_strange_keys(self, but: str) -> bool:
        """Return whether the packages of the workspace need several other unknown keys that are no misspelt names."""
        found: set[str] = set()
        names = sorted({need.name for facts in self.declared.workspace.packages for need in facts.dependencies} - {but})
        for name in names:
            if NO_PACKAGE.fullmatch(name) and self.is_strange(name):
                found.add(name)
                if len(found) == ENOUGH:
                    return True
        return False

    def is_strange(self, name: str) -> bool:
        workspace = self.declared.workspace
        if workspace.is_available(name) or workspace.index.is_package(name) or workspace.index.is_key(name):
            return False
        return wrong_name(self.declared, Dependency(self.declared.manifest.root, "", name, Span(0, 0))) is None


def is_listed(name: str, files: PackageFiles) -> bool:
    """Return whether a YAML file that is called after rosdep has a name among its keys."""
    key = re.compile(rf"(?m)^[\"']?{re.escape(name)}[\"']?[ \t]*:")
    return any(key.search(owner.readable_text(path)) for owner, path in files_called(files, LIST))
