"""Plugins as they are asked for: `KIND` or `NAME:KIND`."""

from __future__ import annotations

from ..light_dataclasses import dataclass
from ..ros.plugins import BASE_HEADERS, LOADED_FROM
from . import ScaffoldError
from .names import check_form
from .plugin_kinds import PluginKind, plugin_kind, plugin_kinds
from .short_words import closest_name
from .template import Template

OWN_HEADER = "filter"
"""The header of the base class that a package has for plugins of its own."""

TAKEN = frozenset({OWN_HEADER, "base"})


@dataclass(frozen=True)
class RequestedPlugin:
    name: str
    kind: PluginKind
    package: str
    """The package as its code calls it: the namespace."""

    @property
    def class_name(self) -> str:
        return "".join(word.capitalize() for word in self.name.split("_"))

    @property
    def type(self) -> str:
        return f"{self.package}::{self.class_name}"

    @property
    def lookup_name(self) -> str:
        """The name that configurations have for it: ros2_control's are written with a slash."""
        slashed = self.base.startswith(("hardware_interface::", "controller_interface::"))
        return f"{self.package}/{self.class_name}" if slashed else self.type

    @property
    def library(self) -> str:
        """Its target and its library: lib/ is everybody's, so it begins with the name of the package."""
        return self.name if f"{self.name}_".startswith(f"{self.package}_") else f"{self.package}_{self.name}"

    @property
    def base(self) -> str:
        return self.kind.base.format(package=self.package)

    @property
    def is_own(self) -> bool:
        """Whether its base class is one of its own package."""
        return self.kind.base.startswith("{package}")

    @property
    def header(self) -> str:
        """The header of the base class; "" where pluginlib has no part in it."""
        return f"{self.package}/{OWN_HEADER}.hpp" if self.is_own else BASE_HEADERS.get(self.base, "")

    @property
    def exported_to(self) -> str:
        """The package that its description is exported to; "" where it has none."""
        return self.package if self.is_own else LOADED_FROM.get(self.base, "")

    @property
    def description(self) -> str:
        """The path of its description."""
        return f"plugins/{self.name}.xml"

    @property
    def targets(self) -> list[str]:
        """What it is linked against, in order."""
        return sorted(filter(None, self.kind.libraries.values()), key=lambda target: target.lstrip("${"))

    @property
    def header_packages(self) -> list[str]:
        """The packages whose headers it includes, and that have no target to link."""
        return sorted(package for package, target in self.kind.libraries.items() if not target)


def plugins_of(asked: tuple[str, ...], package: str, template: Template, distro: str) -> tuple[RequestedPlugin, ...]:
    """Return the plugins, one for a base class of the package's own where none was asked for; raises ScaffoldError."""
    if not template.plugins:
        if asked:
            words = " ".join(f"--plugin {text}" for text in asked)
            raise ScaffoldError(f"plugins are in a package of their own: rospkg new {package}_plugins {words}")
        return ()
    plugins: dict[str, RequestedPlugin] = {}
    for text in asked or (plugin_kinds()[0],):
        plugin = plugin_of(text, package, distro)
        if plugin.name in plugins:
            raise ScaffoldError(f"the plugin `{plugin.name}` is named twice; write NAME:KIND, each with another name")
        plugins[plugin.name] = plugin
    return tuple(plugins.values())


def plugin_of(text: str, package: str, distro: str) -> RequestedPlugin:
    """Return one plugin, called like its package where it has no name; raises ScaffoldError."""
    name, colon, kind = text.rpartition(":")
    if kind not in plugin_kinds():
        known = ", ".join(plugin_kinds())
        hint = closest_name(kind, plugin_kinds())
        raise ScaffoldError(f"there is no kind of plugin `{kind}`{hint}; known: {known}")
    name = name if colon else package
    check_form("plugin", name)
    if name in TAKEN:
        raise ScaffoldError(f"a plugin can't be called `{name}`; choose another name")
    return RequestedPlugin(name, plugin_kind(kind, distro), package)


def plugin_packages(plugins: tuple[RequestedPlugin, ...]) -> list[str]:
    """Return the packages that plugins need, each once, sorted."""
    return sorted({package for plugin in plugins for package in plugin.kind.libraries})
