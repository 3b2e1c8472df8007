"""What to do with a dependency that is a plain CMake project of the workspace (DEP001)."""

from __future__ import annotations

from ...package.workspace import Workspace


def advice_for_project(name: str, workspace: Workspace) -> str:
    """Return what makes rosdep pass a project that colcon finds by its CMakeLists.txt; "" where there is none."""
    if not (folder := workspace.folder_of_project(name)):
        return ""
    todo = f"give it a package.xml (build type cmake), or have rosdep skip it (`--skip-keys {name}`)"
    return f"it is a plain CMake project here (`{folder}`): {todo}"
