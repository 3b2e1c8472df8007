"""Whether a package of the workspace installs a header where those who use it look."""

from __future__ import annotations

from ...package.workspace import Workspace


def is_installed_header(header: str, workspace: Workspace) -> bool:
    """Return whether a package of the workspace has a header of that path.

    rosidl lets those who use a package of interfaces look in `include/<package>` as well.
    """
    if workspace.having("header_files", header):
        return True
    folder = header.partition("/")[0]
    return any(facts.name == folder for facts in workspace.having("header_files", f"{folder}/{header}"))
