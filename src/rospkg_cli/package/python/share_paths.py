"""Paths in share directories, as Python code joins them: the calls that return such a directory."""

from __future__ import annotations

import ast

from ...languages.python.joined_paths import PathJoiner
from ...languages.python.nodes import last_name

SHARE = frozenset({"get_package_share_directory", "get_package_share_path", "FindPackageShare"})


def share_of(call: ast.Call, joiner: PathJoiner) -> str:
    """Return the package whose share directory a call returns; "" for other calls."""
    if last_name(call.func) not in SHARE or not call.args:
        return ""
    return joiner.text(call.args[0]) or ""
