"""Where C++ headers come from: the first folder of an include, and the CMake package or ROS package behind it."""

from __future__ import annotations

from collections.abc import Mapping

from .read_table import pairs, words

LIBRARIES: Mapping[str, str] = pairs("headers.txt", "libraries")
"""Folders of libraries, by the name that find_package has for them."""

SHARED = words("headers.txt", "shared")
"""Folders that several packages put headers into, or that are no package's at all."""

BESIDE_INTERFACES = words("headers.txt", "beside interfaces")
"""Packages of messages that have headers of their own in addition to those of their messages."""
