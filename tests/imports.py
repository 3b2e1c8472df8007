"""The import graph of the house, read from its sources."""

from __future__ import annotations

import ast
from functools import cache
from pathlib import Path

SRC = Path(__file__).parents[1] / "src" / "rospkg_cli"


@cache
def modules() -> dict[str, ast.Module]:
    """Return dotted name (without `rospkg_cli.`) → syntax tree, of every module."""
    found = {}
    for path in sorted(SRC.rglob("*.py")):
        parts = path.relative_to(SRC).with_suffix("").parts
        name = ".".join(parts[:-1] if parts[-1] == "__init__" else parts)
        found[name] = ast.parse(path.read_text())
    return found


@cache
def imports(name: str) -> frozenset[str]:
    """Return the modules of the house that a module imports, wherever in it."""
    known, found = modules(), set()
    is_package = (SRC / Path(*name.split(".")) / "__init__.py").exists() if name else True
    for node in ast.walk(known[name]):
        if isinstance(node, ast.ImportFrom):
            found |= {target for target in targets(name, is_package, node) if target in known}
        elif isinstance(node, ast.Import):
            found |= {a.name.removeprefix("rospkg_cli.") for a in node.names if a.name.startswith("rospkg_cli.")}
    return frozenset(found - {name})


def targets(name: str, is_package: bool, node: ast.ImportFrom) -> set[str]:
    if node.level == 0:
        if not (node.module or "").startswith("rospkg_cli"):
            return set()
        base = (node.module or "").removeprefix("rospkg_cli").lstrip(".")
    else:
        parts = name.split(".") if name else []
        up = node.level - (1 if is_package else 0)
        parts = parts[: len(parts) - up] if up else parts
        base = ".".join([*parts, *((node.module or "").split(".") if node.module else [])])
    joined = {f"{base}.{a.name}".lstrip(".") for a in node.names}
    inner = {each for each in joined if each in modules()}
    return inner | ({base} if len(inner) < len(joined) else set())


def outside(name: str) -> frozenset[str]:
    """Return the top-level modules that are not of the house and that a module imports."""
    found = set()
    for node in ast.walk(modules()[name]):
        if isinstance(node, ast.ImportFrom) and node.level == 0:
            found.add((node.module or "").partition(".")[0])
        elif isinstance(node, ast.Import):
            found |= {alias.name.partition(".")[0] for alias in node.names}
    return frozenset(found - {"rospkg_cli"})
