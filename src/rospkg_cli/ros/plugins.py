"""Who loads which plugins, and who has them."""

from __future__ import annotations

from collections.abc import Mapping

from .read_table import pairs

RQT = frozenset({"rqt_gui", "qt_gui"})
"""These read `<export><rqt_gui plugin="…"/></export>` of package.xml; all others go by what CMake exports."""

LOADED_FROM: Mapping[str, str] = pairs("plugins.txt", "base classes")
"""Base class → the package under whose name descriptions of its plugins must be exported."""

BASE_HEADERS: Mapping[str, str] = pairs("plugins.txt", "headers")
"""Base class → the header that has it, on every distribution; not of all base classes."""

PLUGIN_PACKAGES: Mapping[str, str] = pairs("plugins.txt", "packages")
"""The packages of plugins whose names begin with another name than the package's, by that name or by the whole one."""

TOOLS = frozenset({"rviz_common", "rviz_default_plugins"})
"""What comes with the only program that reads their names."""
