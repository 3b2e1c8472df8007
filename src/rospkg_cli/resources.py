"""Find the data files of rospkg: schemas and templates."""

from __future__ import annotations

from pathlib import Path

HERE = Path(__file__).resolve().parent


def resources(kind: str) -> Path:
    """Return the folder of `schemas` or `templates`: `_schemas` in an installed wheel, `schemas/` in a checkout."""
    installed = HERE / f"_{kind}"
    return installed if installed.is_dir() else HERE.parents[1] / kind
