"""Class loaders of pluginlib that name a package which does not exist (PLG005)."""

from __future__ import annotations

from collections.abc import Iterator

from ...light_dataclasses import dataclass
from ...package.package_facts import PackageFacts
from ...package.plugins.loaders import PluginLoader, PluginLoaders
from ...package.workspace import Workspace
from ...ros.names import NameKind
from ...suggest import nearest


@dataclass(frozen=True)
class UnmatchedLoader:
    """A ClassLoader that looks for plugins of a package that does not exist."""

    loader: PluginLoader
    suggestion: str | None


def unmatched_loaders(loaders: PluginLoaders, facts: PackageFacts, workspace: Workspace) -> Iterator[UnmatchedLoader]:
    """Yield the class loaders of a package that name an unknown package, to which no plugin of the base is exported."""
    for loader in loaders.loaders if facts.is_ament else ():
        package, base = loader.names
        known = workspace.kind_of(package)
        is_around = workspace.is_available(package) or workspace.is_listed(package)
        if known is NameKind.PACKAGE or is_around or package == facts.name:
            continue
        served = {each for plugin in workspace.plugins_of(base) for each in plugin.packages}
        if package not in served and (served or known is NameKind.UNKNOWN):
            suggestion = served.pop() if len(served) == 1 else nearest(package, workspace.names)
            yield UnmatchedLoader(loader, suggestion)
