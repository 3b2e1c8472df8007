"""Imports of modules that ROS 1 alone has: a file ends there, and nothing behind runs."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ...languages.python.imports import Import
from ...light_dataclasses import dataclass
from ...package.python.python_imports import PackageImports
from ..python.ros1_import import ROS1, ros1_import
from .declared_dependencies import DeclaredDependencies
from .import_use import ImportUse
from .pip_installs import PipInstalls, normalized

OF_ROS1 = frozenset(
    "actionlib dynamic_reconfigure moveit_commander rosbag rosgraph roslaunch rosmaster rosnode rosparam rosservice "
    "rostopic tf tf_conversions".split()
)
"""Modules of packages that no distribution of ROS 2 has, though some of them can be had for it by other ways."""


@dataclass(frozen=True)
class Ros1ImportEnds:
    declared: DeclaredDependencies
    python: PackageImports
    pip: PipInstalls

    def first(self, imports: Iterable[Import]) -> Import | None:
        """Return the first of some imports whose module ROS 1 alone has, and that no dependency or pip brings."""
        for each in ros1_imports(imports):
            top = each.module.partition(".")[0]
            is_brought = top in self.declared.names or self.declared.workspace.providers_of(top)
            if not is_brought and normalized(top) not in self.pip.names:
                return each
        return None

    def leftovers(self) -> Iterator[ImportUse]:
        """Yield the first such import of each installed file, unless package.xml is for ROS 1 as well."""
        is_for_both = not ROS1.isdisjoint(each.name for each in self.declared.manifest.dependencies)
        for file in self.python.files if self.declared.is_checked and not is_for_both else ():
            first = (ros1_import(file.imports) or self.first(file.imports)) if file.role == "run" else None
            if first is not None:
                yield ImportUse(file.path, first.span, first.module)


def ros1_imports(imports: Iterable[Import]) -> Iterator[Import]:
    """Yield the imports that are not optional and whose module is of ROS 1, and rarely installed otherwise."""
    for each in imports:
        is_certain = not (each.is_optional or each.is_for_typing or each.is_local or each.level)
        if is_certain and each.module.partition(".")[0] in OF_ROS1:
            yield each
