"""`--minimal`: what a first package needs, and nothing else."""

from __future__ import annotations

from ..light_dataclasses import replace
from .answers import Request
from .template import Template

LEFT_OUT = frozenset({"_shared/CONTRIBUTING.md", "_shared/README.md", "_shared/gitignore", "README.md"})
"""The sources that nothing is built, run or tested with; a license text is what every release needs."""

OF_AMENT = "_shared/CONTRIBUTING.md"
"""What ament_copyright, one of ament's linters, wants in the root of a repository."""


def minimal_request(request: Request) -> Request:
    """Return a request with parameters declared in code alone, and tests that need no ROS where none were typed."""
    return replace(request, params=False, tests=request.tests or "minimal") if request.minimal else request


def minimal_template(template: Template, request: Request) -> Template:
    """Return a template without what may be left out, if it may."""
    if not request.minimal:
        return template
    left_out = LEFT_OUT - {OF_AMENT} if request.tests == "ament" else LEFT_OUT
    return replace(template, files=tuple(file for file in template.files if file.source not in left_out))
