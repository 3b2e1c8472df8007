"""Attributes of the module `rclpy` that it does not have, and nearly has, or that rospy had."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from ...languages.python.file import PythonFile
from ...languages.python.nodes import nodes_of_kind
from ...ros.rclpy_names import OF_ROSPY, names_of_rclpy
from ...suggest import near_names

FAR = 2
"""How many letters a name may be away from one that exists."""


def of_module(file: PythonFile) -> Iterator[tuple[ast.Attribute, str, str]]:
    """Yield attributes of the module that are nearly one of its own, or that rospy had."""
    if not any(each.module == "rclpy" and not each.names for each in file.imports) or rebinds(file):
        return
    known = names_of_rclpy()
    for node in nodes_of_kind(file.tree, ast.Attribute):
        if not (isinstance(node.value, ast.Name) and node.value.id == "rclpy" and isinstance(node.ctx, ast.Load)):
            continue
        if node.attr in known or node.attr.startswith("_"):
            continue
        near = near_names(node.attr, public(known), FAR)
        if better := OF_ROSPY.get(node.attr) or (f"rclpy.{near[0]}" if near else ""):
            yield node, "rclpy", better


def rebinds(file: PythonFile) -> bool:
    """Return whether a file binds `rclpy` itself, or gives the module attributes."""
    names = any(each.id == "rclpy" and isinstance(each.ctx, ast.Store) for each in nodes_of_kind(file.tree, ast.Name))
    return names or any(
        isinstance(each.ctx, ast.Store) and ast.unparse(each.value) == "rclpy"
        for each in nodes_of_kind(file.tree, ast.Attribute)
    )


def public(names: frozenset[str]) -> frozenset[str]:
    """Return the names without a leading underscore."""
    return frozenset(each for each in names if not each.startswith("_"))
