"""Options of `rospkg new` that exclude each other."""

from __future__ import annotations

from ...scaffold.answers import Request
from .. import UsageError


def check_together(request: Request, existing: bool, both: bool, family: bool) -> None:
    """Raise UsageError for options that exclude each other; `existing`: one is about a folder that is there."""
    if request.own_template and request.template != "ament_python":
        raise UsageError("--template replaces --type; leave one of them out")
    if request.own_template and request.minimal:
        raise UsageError("--minimal is for our own types of packages; leave it or --template out")
    if both:
        raise UsageError("--force replaces what --skip leaves alone; choose one of them")
    if family and request.own_template:
        raise UsageError("--family writes our own types of packages; leave --template out")
    if family and request.template == "workspace":
        raise UsageError(
            f"the workspace comes first: `rospkg new {request.name} --type workspace`, and then "
            f"`rospkg new ROBOT --family --into {request.name}/src`"
        )
    if family and existing:
        raise UsageError(
            "--family writes packages that are not there yet; --diff, --force and --skip require a single package"
        )
