"""`--params generate`: nodes whose parameters are declared by code that generate_parameter_library makes.

Source: its README, `cmake/generate_parameter_library.cmake` and `setup_helper.py`, the same in what Humble, Jazzy and
Kilted have (its branch `humble`) and in what Lyrical and Rolling have (1.2).
"""

from __future__ import annotations

from ..light_dataclasses import replace
from ..suggest import did_you_mean
from . import ScaffoldError
from .requested_node import RequestedNode
from .template import Template

PARAMETER_FORMS = {
    "file": "declared in the nodes' code, with a file of values",
    "generate": "declared by generate_parameter_library from definitions in YAML, with a file of values",
}


def is_generating(asked: str, template: Template) -> bool:
    """Return whether the library declares the parameters; raises ScaffoldError where it can't, or for another word."""
    if asked and asked not in PARAMETER_FORMS:
        known = ", ".join((*PARAMETER_FORMS, "none"))
        raise ScaffoldError(f"parameters can't be `{asked}`{did_you_mean(asked, PARAMETER_FORMS)}; known: {known}")
    if asked != "generate":
        return False
    if not template.generates:
        raise ScaffoldError("--params generate is for packages of --type ament_python, ament_cmake or mixed")
    return True


def generating(nodes: tuple[RequestedNode, ...]) -> tuple[RequestedNode, ...]:
    """Return the nodes with generated parameters; raises ScaffoldError for one with the name of generated code."""
    found = tuple(replace(node, is_generated=bool(node.kind.parameters)) for node in nodes)
    made = {node.definitions: node.name for node in found if node.definitions}
    for node in found:
        if node.name in made:
            raise ScaffoldError(
                f"`{node.name}` is the name of what is generated for the node `{made[node.name]}`; choose another name"
            )
    return found
