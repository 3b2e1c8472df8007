"""Python files of a CMake package that others import by dotted names: `pkg.decisions.attack`."""

from __future__ import annotations

import re
from collections.abc import Iterable

from ...files import PackageFiles
from ...lazy_regex import regex

FROM = regex(r"^[ \t]*from[ \t]+\.*([\w.]*)[ \t]+import[ \t]+(\([^()]*|[^\n#]*)", re.MULTILINE)
IMPORT = regex(r"^[ \t]*import[ \t]+([^\n#]*)", re.MULTILINE)
NAME = regex(r"[\w.]+")
STARTS_ITSELF = regex(r"^if[ \t(]+__name__", re.MULTILINE)


def is_only_imported(path: str, files: PackageFiles) -> bool:
    """Return whether another Python file imports a file by a dotted name, and it does not start itself."""
    if not path.endswith(".py") or STARTS_ITSELF.search(files.readable_text(path)):
        return False
    parts = path.removesuffix(".py").split("/")
    names = {".".join(parts[start:]) for start in range(len(parts) - 1)}
    others = (files.readable_text(each) for each in files.paths if each.endswith(".py"))
    return not names.isdisjoint(dotted_imports(text for text in others if parts[-1] in text))


def dotted_imports(texts: Iterable[str]) -> frozenset[str]:
    """Return each name that texts import, or import something of; relative ones without their first dots."""
    found: set[str] = set()
    for text in texts:
        for module, names in FROM.findall(text):
            found.update((module, *(f"{module}.{name}" for name in NAME.findall(names))))
        for names in IMPORT.findall(text):
            found.update(NAME.findall(names))
    return frozenset(found)
