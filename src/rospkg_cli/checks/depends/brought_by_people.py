"""Python libraries that people have without package.xml, because they chose them or got them with another.

A library that only PyPI has brings what it requires; a framework that works on a graphics card is chosen for that card,
and the repository of an unknown package is cloned.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ...package.python.python_imports import PythonImports
from .declared_dependencies import DeclaredDependencies
from .fetched_repositories import FetchedRepositories
from .import_provider import import_providers
from .name_source import source_of
from .pip_installs import key_of, normalized
from .pip_requirements import FRAMEWORKS, OTHERWISE, distributions_of, required_by

FETCHED = "; a repository that a page, a script or a job here names or fetches may have it"
FRAMEWORK = "; people install this one for the graphics card that they have, and the key brings a build for the CPU"


def why_brought(declared: DeclaredDependencies, files: Iterable[PythonImports], module: str, key: str) -> str:
    """Return why people have a library without package.xml, as the end of a message; "" for others."""
    top = module.partition(".")[0]
    if top in FRAMEWORKS:
        return FRAMEWORK
    index = declared.workspace.index
    if not index.is_key(key) and not distributions_of(key):
        return FETCHED if source_of(declared, key) == "unknown" and is_fetched(declared, key) else ""
    found = required_by(imported_from_pip(declared, files)).items()
    bringer = next((by for name, by in found if name == normalized(top) or key_of(name, index) == key), "")
    return bringer and f"; the package imports `{bringer}`, too, which pip installs, and which requires it"


def is_fetched(declared: DeclaredDependencies, package: str) -> bool:
    return FetchedRepositories(declared.release.files, declared.workspace, declared.otherwise.hidden).may_have(package)


def imported_from_pip(declared: DeclaredDependencies, files: Iterable[PythonImports]) -> Iterator[str]:
    """Yield the distributions that the programs of a package need when they start, and that rosdep has of pip alone."""
    imports = (each for file in files if file.role == "run" for each in file.imports)
    for each in imports:
        if not (each.is_optional or each.is_for_typing or each.is_local):
            top = each.module.partition(".")[0]
            names = import_providers(declared, each)
            if top in FRAMEWORKS or not names or source_of(declared, names[0]) == "pip":
                yield OTHERWISE.get(top, normalized(top))
