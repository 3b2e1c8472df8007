"""The packages whose plugins robots, RViz configs and parameter files name (`nav2_navfn_planner::NavfnPlanner`)."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cached_property

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.file_role import role_of
from ...package.plugin import PluginUse
from ...ros.implied_dependencies import IN_PARAMETERS, implied_by
from ...ros.names import NameKind
from ...ros.plugins import PLUGIN_PACKAGES, TOOLS
from .brought_dependencies import brought_by
from .declared_dependencies import DeclaredDependencies
from .files_in_use import FilesInUse
from .robot_use import RobotUse
from .spawned_blocks import block_of, is_commented_out, other_types

INTERFACES = regex(r".*_(?:msgs|srvs|interfaces|actions)")
LOADS_PLUGINS = regex(
    r"controller_manager$|gz_ros2_control|ign_ros2_control|gazebo_ros2_control|nav2_|moveit|navigation2$|.*_bringup$"
)
"""Packages that load plugins by the names in parameter files, or whose launch files start such."""
LOADED_BY_OWN = frozenset({"laser_filters", "slam_toolbox"})
"""Packages whose plugins their own node alone loads: where that is not installed, nothing looks for them."""
GENERATED = frozenset({"msg", "srv", "action"})
RUN = frozenset({"depend", "exec_depend"})


@dataclass(frozen=True)
class RobotPlugins:
    used: FilesInUse

    @property
    def declared(self) -> DeclaredDependencies:
        return self.used.launch.declared

    def all(self, *, tests: bool = False) -> Iterator[tuple[str, RobotUse]]:
        """Yield the packages of plugins that files of tests, or all other files, name and that no dependency brings.

        They are optional in RViz configs and robots, which may be used without them, and in parameters of a package
        whose launch files start nothing that loads plugins: these are for nodes of other packages.
        """
        for use in self.declared.facts.plugin_uses:
            is_chosen = role_of(use.path) == "test" if tests else self.used.is_used(use.path)
            name = self.package_of(use) if is_chosen else None
            if name is not None and name not in self.available and name not in TOOLS:
                is_optional = not use.path.endswith((".yaml", ".yml")) or not self.loads_plugins
                is_optional = is_optional or name in LOADED_BY_OWN or not self.used.parameters.may_have(use.path)
                is_optional = is_optional or self.is_passed_over(use) or not (use.is_listed or self.is_needed)
                usage, consequence = f"and its plugin `{use.name}` is named here", "the node can't load it"
                yield name, RobotUse(use.path, use.span, usage, consequence, is_optional)

    def is_passed_over(self, use: PluginUse) -> bool:
        """Return whether launch files spawn other controllers of the same controller_manager by name, but not this one.

        True as well where a comment alone has the type of the controller, or where the launch files spawn none at all.
        """
        text = self.used.files.source(use.path).text
        if is_commented_out(text, use.span.start):
            return True
        own = block_of(text, use.span.start)
        if own is None or self.is_needed or self.used.parameters.is_spawned(own):
            return False
        if not self.used.parameters.may_spawn:
            return True
        return any(self.used.parameters.is_spawned(name) for name in other_types(text, own))

    @cached_property
    def is_needed(self) -> bool:
        """Whether another package of the workspace depends on this one, and may spawn what this one does not."""
        return self.declared.workspace.is_needed(self.declared.facts.name)

    def package_of(self, use: PluginUse) -> str | None:
        """Return the package of a plugin; None for what may be the name of something else."""
        first, second, *_ = re.split(r"/|::", use.name)
        if elsewhere := PLUGIN_PACKAGES.get(use.name) or PLUGIN_PACKAGES.get(first):
            return elsewhere
        owner = self.declared.workspace.named(first)
        if owner is None and self.declared.workspace.kind_of(first) is NameKind.PACKAGE:
            return None if second in GENERATED or INTERFACES.fullmatch(first) else first
        if owner is not None and any(plugin.name == use.name for plugin in owner.plugins):
            return first
        return self.describing(use.name)

    def describing(self, name: str) -> str | None:
        """Return the last package of the workspace that describes a plugin of a name."""
        word = re.split(r"/|::", name)[-1]
        packages = (facts for facts in self.declared.workspace.packages if facts.may_have("plugins", (word,)))
        found = [facts.name for facts in packages if any(plugin.name == name for plugin in facts.plugins)]
        return found[-1] if found else None

    @cached_property
    def loads_plugins(self) -> bool:
        """Whether launch files start a node that loads plugins of parameter files, or include a file that does."""
        return any(LOADS_PLUGINS.match(name) for name in self.used.started)

    @cached_property
    def available(self) -> frozenset[str]:
        """What is installed with the declared packages and those that launch files start, as far as it is known.

        A node that launch files start has the dependencies of its package, wherever it can be started at all.
        """
        waiting, undeclared = list(self.declared.names | self.used.started), self.used.started - self.declared.names
        found = {*implied_by(waiting, IN_PARAMETERS), *brought_by(sorted(undeclared), self.declared.workspace)}
        while waiting:
            facts = self.declared.workspace.named(waiting.pop())
            new = {need.name for need in facts.dependencies if need.tag in RUN} - found if facts else set()
            found |= new | implied_by(new, IN_PARAMETERS)
            waiting += new
        return frozenset(found)
