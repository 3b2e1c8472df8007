"""What happens where a file that a launch file names is missing."""

from __future__ import annotations

from ...package.launch.file_references import ReferenceKind
from .launch_context import LaunchContext
from .missing_reference import MissingReference
from .relative_parameter_files import has_other_values, is_for_nodes

HARM: dict[ReferenceKind, str] = {
    "include": "the launch stops there, as the file can't be opened",
    "open": "the launch stops there, as the file can't be opened",
    "default": "what opens it fails unless another one is given",
    "file": "what opens it finds nothing there",
    "caught": "what opens it goes on without it, and prints no warning",
}
WITHOUT_PARAMETERS = "launch warns, and the node starts with its defaults"
WITHOUT_SOME = "launch warns, and the node starts without what it sets"
"""For a node that is given other files or values too."""


def harm_at(scope: LaunchContext, missing: MissingReference, why: str) -> str:
    """Return the message on a missing file without what to do; `why` says when it does no harm, or is ""."""
    harm = f"{harm_of(scope, missing)}{why and ', '}{why}"
    if missing.state == "no slash":
        return f"there is no `/` between the share directory of `{missing.package}` and `{missing.path}`: {harm}"
    return f"`{missing.package}` has no file `{missing.path}`: {harm}"


def harm_of(scope: LaunchContext, missing: MissingReference) -> str:
    if is_for_nodes(scope, missing):
        return WITHOUT_SOME if has_other_values(scope, missing) else WITHOUT_PARAMETERS
    return "RViz starts with its default view" if missing.is_for_rviz else HARM[missing.use]
