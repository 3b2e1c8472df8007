"""From the paths that a user gave to the packages they mean, and the workspace around them."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from pathlib import Path

from ...config.hierarchy import NO_CONFIGS, ConfigTree
from ...current_folder import absolute, current_folder
from ...disk_trace import exists, is_file, is_folder, real_path, scan
from ...fence import is_shared
from ...leftovers import is_never_source
from ...light_dataclasses import dataclass
from ...user_error import UserError
from ..run.scope import Scope
from .cmake_projects import LIST, cmake_projects, read_list
from .discover import PassedBy, enclosing_package, packages_below, repositories
from .exclusions import Exclusions
from .hidden_packages import VENDOR_FOLDERS, describe_hidden
from .incomplete_workspace import missing_packages
from .installed_packages import installed_package_names


class LocateError(UserError):
    """A path that can't be linted; the message says why."""


@dataclass(frozen=True)
class Located:
    root: Path
    """Everything lies below it."""
    scope: Scope
    exclusions: Exclusions
    hidden: str = ""
    """Why packages were left out, where all were."""


def locate(paths: Sequence[Path], workspace: Path | None = None, configs: ConfigTree = NO_CONFIGS) -> Located:
    """Find the packages; raises LocateError for a path that is not there. `exclude` of the configs leaves some out."""
    exclusions, config = Exclusions(configs), configs.root
    given: list[Path] = []
    passed = PassedBy()
    for path in paths:
        if not exists(path):
            raise LocateError(f"`{path}` does not exist; give the path of a package or of a workspace")
        given += packages_at(absolute(path), passed)
    kept = [p for p in each_once(given) if not exclusions.leave_out(p)]
    around = absolute(workspace) if workspace else workspace_of(kept)
    others = packages_below(around, passed=passed) if around else siblings(kept, passed.plain)
    every = sorted(each_once([*kept, *(p for p in others if not exclusions.leave_out(p))]))
    anchors = [*every, *([around] if around else []), *([config.folder] if config.path and not configs.is_only else [])]
    root = Path(os.path.commonpath(anchors)) if every else current_folder()
    missing = missing_packages(around, kept)
    scope = Scope(
        folders=tuple(relative(p, root) for p in every),
        selected=frozenset(relative(p, root) for p in kept),
        name=root.name,
        incomplete=missing.why,
        missing_repositories=missing.repositories,
        prefix_names=installed_package_names(os.environ),
        cmake_projects=cmake_projects(passed.plain, every, root, read_list),
        repositories=repositories((relative(p, root) for p in every), lambda f, marks: is_marked(root / f, marks)),
    )
    hidden = "" if kept else "the config excludes them" if given else describe_hidden(paths)
    return Located(root, scope, exclusions, hidden)


def each_once(packages: Iterable[Path]) -> list[Path]:
    """Return each package under the first of the paths that lead to it."""
    found: dict[str, Path] = {}
    for package in packages:
        found.setdefault(real_path(package), package)
    return list(found.values())


def siblings(packages: Iterable[Path], plain: list[Path]) -> Iterator[Path]:
    """Yield the packages next to some others, where there is no workspace around them; add those of plain CMake."""
    for folder in dict.fromkeys(package.parent for package in packages):
        if not is_shared(folder):
            with suppress(OSError):
                names = [entry.name for entry in scan(folder) if not is_never_source(entry.name)]
                beside = [folder / name for name in names if is_file(folder / name / "package.xml")]
                yield from beside
                plain += [folder / n for n in names if folder / n not in beside and is_file(folder / n / LIST)]


def is_marked(folder: Path, marks: Sequence[str]) -> bool:
    return any(exists(folder / mark) for mark in marks)


def packages_at(path: Path, passed: PassedBy) -> list[Path]:
    """Return the packages that a path means: the one it lies in, else those below it."""
    around = enclosing_package(path if is_folder(path) else path.parent)
    if around:
        return [around]
    return [
        p for p in packages_below(path, passed=passed) if not VENDOR_FOLDERS.intersection(p.relative_to(path).parts)
    ]


def relative(path: Path, root: Path) -> str:
    found = path.relative_to(root).as_posix()
    return "" if found == "." else found


def workspace_of(packages: Sequence[Path]) -> Path | None:
    """Return the outermost folder around the packages that looks like a workspace, or None.

    A workspace may lie in another that was built from its own `src`: that is not around the packages.
    """
    if not packages:
        return None
    common = Path(os.path.commonpath(packages))
    found: Path | None = None
    for folder in (common, *common.parents):
        if not is_shared(folder) and looks_like_one(folder, common):
            if found and is_built(folder) and is_folder(folder / "src") and not common.is_relative_to(folder / "src"):
                break
            found = folder
    return found


def is_built(folder: Path) -> bool:
    return all(is_folder(folder / name) for name in ("build", "install", "log"))


def looks_like_one(folder: Path, holds: Path) -> bool:
    """Return whether a folder is a colcon workspace, the parent of the `src` that holds the paths, or a git root."""
    return bool(mark_of_workspace(folder, holds))


def mark_of_workspace(folder: Path, holds: Path) -> str:
    """Return what makes a folder that holds something look like a workspace; "" where nothing does."""
    if is_built(folder):
        return "build, install, log"
    found = next((name for name in ("colcon.meta", ".colcon", ".git") if exists(folder / name)), "")
    return found or ("src" if holds.is_relative_to(folder / "src") else "")
