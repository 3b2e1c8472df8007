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

LOADED_WHOLE = ("image_transport::", "point_cloud_transport::")
"""The beginnings of base classes of which every described plugin is loaded, wherever something publishes."""

OFFERED = ("rviz_common::", "rqt_gui_cpp::")
"""The beginnings of base classes of which a program shows every described plugin in a menu."""

TOOLS = frozenset({"rviz_common", "rviz_default_plugins"})
"""What comes with the only program that reads their names."""
