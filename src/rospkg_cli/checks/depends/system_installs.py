"""Which packages of the system a repository installs by lists and commands of its own: of apt, conda, vcpkg or nix."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable
from functools import cached_property

from ...files import PackageFiles
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.workspace import Workspace
from ...tree import READABLE
from ..repository.pages_and_scripts import pages_and_scripts
from .brought_dependencies import brought_by
from .hand_installs import plain
from .repository_dependencies import repository_of

READ = regex(
    r"(?i)(?:^|/)(?:[^/]*(?:dockerfile|containerfile)[^/]*|[^/]*compose[^/]*\.ya?ml|devcontainer\.json|makefile|justfile"
    r"|\.github/(?:workflows|actions)/.+\.ya?ml|\.gitlab-ci\.yml|snapcraft\.ya?ml|[^/]*\.(?:sh|bash)"
    r"|[^/]*azure-pipelines[^/]*\.ya?ml|\.circleci/config\.ya?ml|\.travis\.ya?ml|jenkinsfile|vagrantfile|earthfile"
    r"|taskfile\.ya?ml|user-data(?:\.ya?ml)?|debian/control"
    r"|(?:[^/]*[-_.])?(?:set-?up|install|bootstrap)(?:[-_.][^/.]*)?(?:\.py)?|(?:ansible|playbooks|roles)/.*\.ya?ml)$"
)
"""Files by which containers, jobs and machines are set up; a setup.py of Python is none."""
LIST = regex(
    r"(?i)(?:^|/)(?:aptfile|(?:[^/]*[-_.])?(?:apt|ubuntu|debian|system|packages|deps|dependencies)"
    r"(?:[-_.][^/]*)?\.(?:txt|list|apt|lst))$"
)
"""Names of packages, one on a line."""
OTHERS = regex(
    r"(?i)(?:^|/)(?:[^/]*(?:environment|conda)[^/]*\.ya?ml|pixi\.toml|vcpkg\.json|brewfile|conanfile\.(?:txt|py)|[^/]*\.nix)$"
)
"""Lists of packages for installers with names of their own."""
NO_LIST = ("CMakeLists.txt", "setup.py", "setup.cfg")
COMMENT = regex(r"(?m)(?:^|[ \t])#.*$")
COMMAND = regex(
    r"\b(?:apt|apt-get|aptitude|nala|brew|dnf|pacman|conda|mamba|micromamba|pixi)\b(?:[ \t]+[^\s;&|]+){0,6}?"
    r"[ \t]+(?:install|add|-S\w*)\b((?:[^\n&|;\\`]|\\\n?)*)"
)
WORD = regex(r"(?<![\w./:${}-])[A-Za-z][A-Za-z0-9.+_-]*[A-Za-z0-9+]")
ROSDEP = regex(r"\brosdep[ \t]+(?:[^\n]*[ \t])?install\b")
BY_COMMAND = "; this repository installs it by a list or a command of its own"
MIN_LETTERS = 3


@dataclass(frozen=True)
class SystemInstalls:
    files: PackageFiles
    workspace: Workspace

    def has(self, names: Iterable[str]) -> bool:
        """Return whether one of some keys of rosdep is installed so, and nothing here runs rosdep.

        Packages of ROS are none: who builds a part of the repository has rosdep find them by package.xml.
        """
        libraries = [name for name in names if self.workspace.index.is_key(name)]
        if not libraries or self.runs_rosdep:
            return False
        return any(name in self.keys or spelt(name) in self.plain_names for name in libraries)

    @cached_property
    def runs_rosdep(self) -> bool:
        """Whether a page, a script or a workflow has rosdep install what package.xml declares."""
        return any(map(ROSDEP.search, pages_and_scripts(self.files)))

    @cached_property
    def keys(self) -> frozenset[str]:
        """The keys that stand for packages which apt installs, and for what comes with these."""
        index = self.workspace.index
        first = {name for name in self.words if index.is_key(name)}
        first |= {key for name in self.words for key in index.apt.get(name, ())}
        return frozenset({*first, *brought_by(sorted(first), self.workspace)})

    @cached_property
    def plain_names(self) -> frozenset[str]:
        """The names of the packages without `lib`, `-dev` and the like."""
        return frozenset(map(spelt, self.words)) - {""}

    @cached_property
    def words(self) -> frozenset[str]:
        return frozenset(word for text in self.texts for word in WORD.findall(text))

    @cached_property
    def texts(self) -> tuple[str, ...]:
        """What files say that is installed; a word of a script counts if it has a dash."""
        whole = PackageFiles(self.files.whole) if self.files.whole is not None else self.files
        root = repository_of(self.files.folder, self.workspace)
        key = "" if self.files.whole is not None else self.files.folder
        paths = self.workspace.index_of(PathsOfInstalls).of(whole, key)
        return tuple(installed_in(path, whole) for path in paths if path.startswith(root))


class PathsOfInstalls(dict[str, tuple[str, ...]]):
    """The paths of files that may say what is installed: a large workspace is looked through once."""

    def of(self, whole: PackageFiles, key: str) -> tuple[str, ...]:
        if key not in self:
            paths = (path for path, kind in whole.tree.files().items() if kind in READABLE)
            self[key] = tuple(path for path in paths if any(each.search(path) for each in (LIST, OTHERS, READ)))
        return self[key]


def installed_in(path: str, files: PackageFiles) -> str:
    """Return the part of a file that names packages which are installed; "" for other files."""
    if posixpath.basename(path) in NO_LIST:
        return ""
    if LIST.search(path) or OTHERS.search(path):
        return COMMENT.sub("", files.readable_text(path))
    if not READ.search(path):
        return ""
    text = COMMENT.sub("", files.readable_text(path))
    dashed = (word for word in WORD.findall(text) if "-" in word)
    return " ".join([*COMMAND.findall(text), *dashed])


def spelt(name: str) -> str:
    """Return a name without what Debian has around it; libraries of Python are others than those of C."""
    found = plain(name)
    if len(found) < MIN_LETTERS:
        return ""
    return f"python {found}" if name.startswith("python") else found
