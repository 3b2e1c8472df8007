"""What happens where a file that a launch file names is missing."""

from __future__ import annotations

from ...package.launch.file_references import ReferenceKind
from .missing_references import LaunchContext, MissingReference
from .relative_parameter_files import has_others_beside, is_for_nodes

HARM: dict[ReferenceKind, str] = {
    "include": "the launch stops there, as the file can't be opened",
    "open": "the launch stops there, as the file can't be opened",
    "default": "what opens it fails unless another one is given",
    "file": "what opens it finds nothing there",
    "caught": "what opens it goes on with nothing, and does not say so",
}
WITHOUT_PARAMETERS = "launch warns, and the node starts with its defaults"
WITHOUT_SOME = "launch warns, and the node starts without what it sets"
"""Where other files or values are given beside it, which the node has."""


def harm_of(scope: LaunchContext, missing: MissingReference) -> str:
    if is_for_nodes(scope, missing):
        return WITHOUT_SOME if has_others_beside(scope, missing) else WITHOUT_PARAMETERS
    return "RViz starts with its default view" if missing.is_for_rviz else HARM[missing.use]
