"""What is installed wherever a launch file is launched: ros2launch, and all that comes with it."""

from __future__ import annotations

from ...package.workspace import Workspace
from .brought_dependencies import brought_by
from .declared_dependencies import DeclaredDependencies

STARTER = "ros2launch"


class ThereToLaunch:
    """The packages that come with `ros2launch`, found once for all packages of a workspace."""

    names: frozenset[str] = frozenset()

    def of(self, workspace: Workspace) -> frozenset[str]:
        """Return `ros2launch`, and all that comes with it."""
        self.names = self.names or frozenset({STARTER, *brought_by([STARTER], workspace)})
        return self.names


def there_to_launch(declared: DeclaredDependencies) -> frozenset[str]:
    """Return the packages that are there wherever a launch file of the workspace is launched."""
    return declared.workspace.index_of(ThereToLaunch).of(declared.workspace)
