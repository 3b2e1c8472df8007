"""What the name of a plugin says: which package it may be of, and whether another name is intended."""

from __future__ import annotations

import re

from ...lazy_regex import regex
from ...package.missing_repositories import telling_words
from ...package.package_facts import PackageFacts
from ...ros.plugins import PLUGIN_PACKAGES
from ...ros.well_known import every_plugin
from ...suggest import near_names
from .exported_classes import tail

SEPARATOR = regex(r"/|::")


def plain(name: str) -> str:
    """Return the class of a name for comparison: in lower case, without blanks and underscores."""
    return re.sub(r"[\s_]", "", tail(name)).lower()


def is_something_else(owner: PackageFacts, name: str) -> bool:
    """Return whether a name is that of a component or of an interface."""
    kinds = {f"{kind}/{tail(name)}" for kind in ("msg", "srv", "action")}
    unsure = not (owner.knows("components") and owner.knows("interfaces"))
    return unsure or name in owner.components or bool(kinds & owner.interfaces)


def is_brought(name: str, user: PackageFacts) -> bool:
    """Return whether a plugin is a well-known one, or of a package that its user depends on and that is not here."""
    first = SEPARATOR.split(name)[0]
    is_known = first in PLUGIN_PACKAGES or name in PLUGIN_PACKAGES or name in every_plugin()
    return is_known or first in {each.name for each in user.dependencies}


def are_related(first: str, other: str) -> bool:
    """Return whether two first names of plugins are a slip apart, or share a word that not everybody's have."""
    return bool(near_names(first, {other})) or not telling_words(first).isdisjoint(telling_words(other))
