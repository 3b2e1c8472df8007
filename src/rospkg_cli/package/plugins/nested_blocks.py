"""Blocks inside of the block of another plugin: that one decides which of their keys are read.

The controller DWB reads the class of a critic as `<critic>.class`, and completes its name; `<critic>.plugin` it never
reads. What a well-known plugin reads stands in the table of the parameters that its package declares.
"""

from __future__ import annotations

from typing import Literal

from ...lazy_regex import regex
from ...ros.known_nodes import known_parameters
from ...ros.well_known import packages_with_plugin
from .unlisted_blocks import Key, ancestors, is_listed, siblings

OWN = "plugin"
"""By which key the servers of Nav2, and some of their plugins, know the name of one."""
VALUE = regex(r"""(["']?)(?P<name>[\w:/]+)\1[ ]*(?:#.*)?""")
Reading = Literal["read", "unread", "unknown"]


def reading_of(text: str, at: int) -> Reading:
    """Return whether the plugin whose block is around the block of a name reads that name.

    A block that is in no other plugin's is a server's own, and that reads it.
    """
    own, block, outer, *_ = [*ancestors(text, at), None, None, None]
    loader = plugin_of(text, block) if block is not None and outer is not None else ""
    if not loader or own is None or own.name != OWN or block is None or is_listed(text, at):
        return "read"
    packages = packages_with_plugin(loader)
    if not packages:
        return "unknown"
    end = f".{block.name}.{OWN}"
    declared = (each for package in packages for each in known_parameters(package) if each.is_tail)
    return "read" if any(each.name == end for each in declared) else "unread"


def plugin_of(text: str, key: Key) -> str:
    """Return the plugin that the mapping around a key is the block of; "" where it is none's."""
    values = (VALUE.fullmatch(each.value) for each in siblings(text, key) if each.name == OWN)
    return next((found["name"] for found in values if found is not None), "")
