"""Names of nodes in parameter files, as rcl checks them (_validate_name in parse.c, rmw_validate_namespace)."""

from __future__ import annotations

import re

TOKEN = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")
WILD = ("*", "**")
MAX_NAME = 255


def joined(names: list[str]) -> str:
    """Put keys together, with one `/` between them where none is."""
    whole = names[0]
    for name in names[1:]:
        whole += name if whole.endswith("/") else f"/{name}"
    return whole


def name_fault(name: str) -> str | None:
    """Return why rcl refuses a name, or None where it does not."""
    if name in ("/**", "/*"):
        return None
    namespace, slash, node = name.rpartition("/")
    if not node:
        return f"`{name}` ends with `/`, where the name of a node belongs"
    if slash and "" in namespace.removeprefix("/").split("/") and namespace not in ("", "/"):
        return f"`{name}` has two `/` in a row"
    if name.startswith("//"):
        return f"`{name}` has two `/` in a row"
    for token in (*namespace.split("/"), node):
        if token and token not in WILD and not TOKEN.fullmatch(token):
            return f"`{token}` is no name of a node or namespace: letters, digits and `_`, no digit first"
    return f"`{node[:20]}…` is longer than {MAX_NAME} characters" if len(node) > MAX_NAME else None
