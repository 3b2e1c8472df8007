"""Versions in setup.py that are not those of package.xml, and who asks for them (SET402)."""

from __future__ import annotations

from rospkg_cli.example import BACKDROPS, SETUP_PY, Example, existing_files, manifest

from .setups import python

CHANGES = "Changelog for package my_pkg\n====\n"
OTHER = SETUP_PY.replace("'1.0.0'", "'0.0.1'")


def copied(more: dict[str, str]) -> Example:
    """A package with changes, beside one of the repository that may have none: then it was copied from elsewhere."""
    files = {f"theirs/{path}": text for path, text in existing_files(BACKDROPS["ament_python"]).items()}
    files |= {"theirs/setup.py": OTHER, "theirs/CHANGELOG.rst": CHANGES}
    files["mine/package.xml"] = manifest("", "ament_cmake", "mine")
    return Example(on="", bad={**files, **more}, good={})


CASES = {
    "SET402": tuple(
        python({**files, "setup.py": OTHER})
        for files in (
            {"CHANGELOG.rst": CHANGES},
            {"CHANGELOG.rst": CHANGES, "tracks.yaml": ""},
            {"my_pkg/a.py": "from importlib.metadata import version\n"},
            {"my_pkg/a.py": "from importlib import resources\n"},
        )
    )
    + tuple(copied(more) for more in ({}, {"mine/CHANGELOG.rst": CHANGES}))
}
