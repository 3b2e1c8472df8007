"""Whether a page or a script of the repository calls a package optional, or what it stands for."""

from __future__ import annotations

import posixpath
import re
from functools import cached_property

from ...files import PackageFiles
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.missing_repositories import COMMON
from ..container_files import files_called

TELLING = regex(r"(?i)(?:\.(?:md|rst|sh|bash)|(?:^|/)(?:makefile|[^/]*dockerfile[^/]*))$")
SAYS_SO = regex(
    r"(?im)^.*(?:可选(?!参数)|オプション|선택|\b(?:opcional|opzionale|optionnel|facultati|opt[- ]in\b)"
    r"|\boptional(?:ly)?\b(?![ \t]+(?:arg|param|flag|field|set|value|over|topic|frame|key|name))"
    r"|\bonly (?:needed|required|necessary) (?:for|if|when|to)\b|\bif you (?:want|wish|plan|like) to use\b).*$"
)
"""A line that calls a part of the software optional, and not an argument."""
CELL = regex(r"[ \t]*\|([^|\n]*)")
ITEM = regex(r"[ \t]*(?:[-*+]|\d+\.)[ \t]+[*_]*`([^`\n]*)`")
"""What a line of a table, or an element of a list that begins with code, is about."""
OF_ANYTHING = COMMON | frozenset(
    "camera depth diagnostic hardware image interactive joint laser micro navigation point pointcloud sensor static "
    "state teleop topic twist vision".split()
)
"""Words by which no page means one package."""
MIN_LETTERS = 5
OPTIONAL = "; a page here calls it optional"


@dataclass(frozen=True)
class OptionalParts:
    files: PackageFiles

    def has(self, package: str) -> bool:
        """Return whether a line calls a package optional by its name, or by the first word of it that says most."""
        patterns = [re.compile(pattern(name), re.IGNORECASE) for name in wanted(package)]
        return any(each.search(line) for each in patterns for line in self.lines)

    @cached_property
    def lines(self) -> tuple[str, ...]:
        texts = (whole.readable_text(path) for whole, path in files_called(self.files, TELLING) if self.is_near(path))
        return tuple(subject(line) for text in texts for line in SAYS_SO.findall(text))

    def is_near(self, path: str) -> bool:
        """Return whether a page is of the package or of the whole repository: not of another package."""
        around = {path[:at] for at, sign in enumerate(path) if sign == "/"} | {""}
        others = around & self.packages - {self.files.folder}
        return all(f"{self.files.folder}/".startswith(f"{each}/" if each else "") for each in others)

    @cached_property
    def packages(self) -> frozenset[str]:
        whole = self.files.whole if self.files.whole is not None else self.files.tree
        return frozenset(posixpath.dirname(path) for path in whole.files() if path.endswith("package.xml"))


def wanted(package: str) -> list[str]:
    """Return the names by which a page may mean a package."""
    words = package.split("_")
    first = words[0].rstrip("0123456789")
    found = {package} if len(package) >= MIN_LETTERS and package not in OF_ANYTHING else set()
    return sorted(found | ({first} if len(first) >= MIN_LETTERS and first not in OF_ANYTHING else set()))


def pattern(name: str) -> str:
    """Return what finds a name as pages write it (`ros_gz` bridge), and not the one of an argument (`use_gazebo`)."""
    words = "[-_` ]{1,3}".join(map(re.escape, name.split("_")))
    return rf"(?<![A-Za-z0-9_/:=]){words}\d?(?![A-Za-z0-9_/:=])"


def subject(line: str) -> str:
    """Return the part of a line that says what is optional."""
    found = CELL.match(line) or ITEM.match(line)
    return found[1] if found else line
