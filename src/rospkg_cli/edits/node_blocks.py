"""Fixes that write the name of another node above a block of a parameter file."""

from __future__ import annotations

from ..finding import Edit, Fix, Safety
from ..package.params.parameter_file import NodeBlock, ParameterFile
from .plain_names import only_plain_names


def renaming(file: ParameterFile, block: NodeBlock, name: str) -> Fix | None:
    """Return the fix that writes another name of a node; None where the key is not just its name."""
    key = block.key.text
    if file.source.slice(block.key.span) != key or key != block.name.rpartition("/")[2]:
        return None
    fix = Fix(f"write `{name}`", (Edit(file.path, block.key.span, name),), Safety.UNSAFE)
    return only_plain_names(fix, name)
