"""The package that a name means: in the workspace around the current folder, or at a path."""

from __future__ import annotations

from pathlib import Path

from ...change import ChangeError
from ...change.draft import Draft
from ...light_dataclasses import replace
from ...package.manifest import Manifest
from ...suggest import did_you_mean
from ..change.place import ChangePlace, place_of


def named_package(typed: str) -> tuple[ChangePlace, dict[str, str]]:
    """Return the place of the package with a name, or at a path; and the names of all packages there, by folder.

    Raises ChangeError where there is none, or several; and as `place_of` does.
    """
    path = Path(typed)
    is_path = len(path.parts) != 1 or (path / "package.xml").is_file()
    place = place_of(path if is_path else Path(), several=not is_path)
    names = names_of(place)
    chosen = [place.folder] if is_path else [folder for folder, name in names.items() if name == typed]
    if not chosen:
        hint = did_you_mean(typed, sorted(names.values()))
        raise ChangeError(f"there is no package `{typed}` in the workspace `{place.root}`{hint}; give its path")
    if len(chosen) > 1:
        raise ChangeError(
            f"`{typed}` is the name of {len(chosen)} packages ({', '.join(chosen)}); give the path of one"
        )
    scope = replace(place.located.scope, selected=frozenset(chosen))
    return replace(place, located=replace(place.located, scope=scope)), names


def names_of(place: ChangePlace) -> dict[str, str]:
    """Return the name of each package of the workspace, by its folder."""
    draft = Draft(place.session.tree)
    found = {folder: draft.package(folder).parts(Manifest).only for folder in place.located.scope.folders}
    return {folder: manifest.name for folder, manifest in found.items() if manifest}
