"""Uses of plugins in the parameter files, robots and RViz configs of packages."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ...light_dataclasses import replace
from ...package.file_role import role_of
from ...package.package_facts import PackageFacts
from ...package.plugin import PluginUse
from ...package.urdf.robot_words import may_be_made
from ...package.workspace import Workspace
from ..yaml_elsewhere import is_named_yaml

YAML, ROBOTS = (".yaml", ".yml"), (".urdf", ".xacro")
BY_MOVEIT = frozenset({"ros2_controllers.yaml", "moveit_controllers.yaml"})
"""Files that moveit_configs_utils opens by their usual names."""


def uses(packages: Iterable[PackageFacts], workspace: Workspace) -> Iterator[tuple[PackageFacts, PluginUse]]:
    """Yield the uses of plugins outside of tests, each with its package.

    A use is kept as one of no list (`is_listed=False`) in a file that nothing opens, as its lists are not read, and for
    a panel of RViz: without the plugin the panel is blank, and nothing else fails.
    """
    for user in packages:
        for use in user.plugin_uses if user.build_type != "catkin" else ():
            if role_of(use.path) != "test":
                is_met = use.kind != "Panel" and is_opened(use.path, user, workspace)
                yield user, use if is_met else replace(use, is_listed=False)


def is_opened(path: str, user: PackageFacts, workspace: Workspace) -> bool:
    """Return whether anything may open a file.

    Where the workspace has launch files, YAML and robots must be named, except for files that MoveIt opens by their
    usual names.
    """
    name = path.rpartition("/")[2]
    if not path.endswith((*YAML, *ROBOTS)) or name in BY_MOVEIT:
        return True
    if not any(facts.launch_files for facts in workspace.packages):
        return True
    if path.endswith(YAML):
        return is_named_yaml(path, user, workspace)
    texts = (words for facts in workspace.packages for words in facts.robot_words)
    return any(name in words or may_be_made(name, words) for words in texts)
