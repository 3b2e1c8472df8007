"""Suggestions for names in Python launch files that nothing defines (LCH013)."""

from __future__ import annotations

from ...languages.python.undefined_names import UndefinedName
from ...ros.launch_exports import exporting_module
from ...suggest import nearest


def hint(found: UndefinedName) -> str:
    home = exporting_module(found.name)
    if home:
        return f"; add `from {home} import {found.name}`"
    near = nearest(found.name, found.known)
    return f"; did you mean `{near}`?" if near else ""
