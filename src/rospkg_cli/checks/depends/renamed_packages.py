"""Unknown packages in robots and parameter files whose files this package, or one of the workspace, has."""

from __future__ import annotations

from ...light_dataclasses import dataclass
from ...package.urdf.robot_file import RobotFile
from .found_by_parameters import named_by_parameters
from .undeclared_launch_packages import LaunchDependencies


@dataclass(frozen=True)
class RenamedPackages:
    launch: LaunchDependencies
    robots: tuple[RobotFile, ...]

    def owner_of(self, name: str) -> tuple[str, list[str]]:
        """Return the package that has each file that robots name in an unknown package, and the files; "" for none.

        The unknown name is then a former name: of this package, or of the only one of the workspace with these files.
        A file that names one with its own path in the other package wraps that one, which is no former name.
        """
        named = [(robot, each) for robot in self.robots for each in robot.references if each.package == name]
        listed = [file for package, file, *_ in named_by_parameters(self.launch.files) if package == name]
        paths = list(dict.fromkeys([*(each.path for _, each in named if each.path), *listed]))
        is_wrapped = any(robot.path == each.path for robot, each in named)
        if not paths or is_wrapped or not self.launch.unknown.has(name):
            return "", []
        if all(map(self.launch.files.exists, paths)):
            return self.launch.declared.facts.name, paths
        having = [each.name for each in self.launch.declared.workspace.packages if each.share_files.issuperset(paths)]
        return (having[0], paths) if len(having) == 1 else ("", [])
