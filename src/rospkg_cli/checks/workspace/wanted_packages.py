"""Whether a package that colcon does not find is needed: something depends on it, uses, builds or runs it by name."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cached_property

from ...files import PackageFiles
from ...light_dataclasses import dataclass
from ...package.launch.live_text import live_text
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from ..repository.linked_build import build_texts
from .carried_folders import CONTINUED, is_page

COMPILED = (".cpp", ".cc", ".cxx", ".hpp", ".h")
USING = (*COMPILED, ".py", ".xml", ".launch", ".yaml", ".yml", "CMakeLists.txt", ".cmake", ".xacro", ".urdf")
USES = r"""
    ^[ \t]*(?:from|import)[ \t]+{0}\b
  | ^[ \t]*\#[ \t]*include[ \t]*[<"]{0}/
  | (?i:\bfind_package\s*\(\s*){0}[\s)]
  | \b\w*[pP]ackage\w*\s*\(\s*(?:package\s*=\s*)?["']{0}["']
  | \$\(find(?:-pkg-\w+)?[ ]{0}\)
  | \b(?:package|pkg)\s*[=:]\s*["']?{0}\b
  | \bpackage://{0}/
"""
"""How code, launch files and robots name a package that they need: an import, a header, a look-up, a node."""
STARTS = r"\bros2[ \t]+(?:run|launch)[ \t]+{0}\b"
BUILDS = r"--packages-(?:select|up-to)(?![\w-])[^\n;&|]*[\s=]{0}(?![\w-])"
"""How pages and scripts start and build one."""


@dataclass(frozen=True)
class WantedPackages:
    files: PackageFiles
    workspace: Workspace

    def has(self, name: str) -> bool:
        """Return whether something needs a package to be built here; packages of a distribution may be installed."""
        if self.is_commanded(BUILDS, name):
            return True
        if self.workspace.index.is_package(name):
            return False
        needed = self.workspace.is_needed(name) or any(is_used(name, each) for each in self.workspace.packages)
        uses = re.compile(USES.format(re.escape(name)), re.VERBOSE | re.MULTILINE)
        return needed or any(map(uses.search, self.code)) or self.is_commanded(STARTS, name)

    def is_commanded(self, commands: str, name: str) -> bool:
        """Return whether a page or a script has a command that names a package."""
        return self.is_in(commands, name, self.pages)

    def is_in(self, patterns: str, name: str, texts: tuple[str, ...]) -> bool:
        wanted = re.compile(patterns.format(re.escape(name)))
        return any(map(wanted.search, texts))

    @cached_property
    def code(self) -> tuple[str, ...]:
        """What the outer package itself says, without comments."""
        paths = [path for path in self.files.paths if path.endswith(USING)]
        compiled = (self.files.readable_text(path) for path in paths if path.endswith(COMPILED))
        return (*compiled, *(live_text(self.files, path) for path in paths if not path.endswith(COMPILED)))

    @cached_property
    def pages(self) -> tuple[str, ...]:
        """What those of the repository and of the outer package say: the inner ones' own tell of another build."""
        return tuple(CONTINUED.sub(" ", text) for text in (*build_texts(self.files), *self.own_pages()))

    def own_pages(self) -> Iterator[str]:
        inner = [path.removesuffix("package.xml") for path in self.files.every if path.endswith("/package.xml")]
        for path in self.files.paths:
            place = path.rpartition("/")[0]
            if is_page(path) and not (place and any(each.startswith(f"{place}/") for each in inner)):
                yield self.files.readable_text(path)


def is_used(name: str, facts: PackageFacts) -> bool:
    """Return whether another package starts, loads, imports or includes something of one."""
    pairs = (*facts.started_nodes, *facts.loaded_components, *((each[0], each[1]) for each in facts.robot_includes))
    modules = {module.partition(".")[0] for module, _ in facts.taken_names}
    headers = {header.partition("/")[0] for header in facts.included_headers}
    return name in {package for package, _ in pairs} | modules | headers | facts.typed_with
