"""Launch files in Python, XML and YAML: what each needs, and what it can do for nodes with a lifecycle."""

from __future__ import annotations

from ..ros.launch_entities import BEFORE_LIFECYCLE_NODE
from ..suggest import did_you_mean
from . import ScaffoldError
from .answers import Answers
from .requested_node import RequestedNode
from .template import Template

NO_FILE = "none"

LAUNCH_FORMATS = {
    "py": "Python, the most common; it may compute what it starts",
    "xml": "XML, shorter",
    "yaml": "YAML, as short, in lists and keys",
    NO_FILE: "no launch file",
}
"""What may be asked for, with what each is."""


def check_typed(asked: str, template: Template) -> None:
    """Raise ScaffoldError where a format was typed and the template can't have it."""
    if asked and not template.launches:
        raise ScaffoldError(f"a package of --type {template.name} has no launch file; leave --launch out")
    if asked == NO_FILE and not template.kinds:
        raise ScaffoldError(f"launch files are what a package of --type {template.name} is for: py, xml or yaml")


def formats_for(template: Template) -> dict[str, str]:
    """Return the formats that a template's launch files can have, with what each is."""
    return {name: what for name, what in LAUNCH_FORMATS.items() if template.kinds or name != NO_FILE}


def launch_format(asked: str, template: Template) -> str:
    """Return the format of the launch files, "" for no launch file; raises ScaffoldError.

    What a config says of all packages does not make one without the files that it is for.
    """
    if asked not in LAUNCH_FORMATS:
        raise ScaffoldError(
            f"there are no launch files in `{asked}`{did_you_mean(asked, LAUNCH_FORMATS)}; "
            f"known: {', '.join(LAUNCH_FORMATS)}"
        )
    if asked == NO_FILE:
        return next(iter(LAUNCH_FORMATS)) if template.launches and not template.kinds else ""
    return asked


def launch_packages(answers: Answers) -> tuple[str, ...]:
    """Return the packages that the launch file needs to be read and run."""
    if not answers.launch:
        return ()
    if answers.launch != "py":
        return (f"launch_{answers.launch}", "launch_ros")
    return ("launch", "launch_ros", *(["lifecycle_msgs"] if lifecycle(answers) else []))


def lifecycle(answers: Answers) -> tuple[RequestedNode, ...]:
    return tuple(node for node in answers.nodes if node.kind.name == "lifecycle")


def autostarted(answers: Answers) -> tuple[RequestedNode, ...]:
    """Return the nodes that a launch file in XML or YAML brings to work with `lifecycle_node`."""
    known = answers.launch in ("xml", "yaml") and answers.distro.name not in BEFORE_LIFECYCLE_NODE
    return lifecycle(answers) if known else ()


def activated(answers: Answers) -> tuple[RequestedNode, ...]:
    """Return the nodes with a lifecycle that the launch file configures and activates."""
    return lifecycle(answers) if answers.launch == "py" else autostarted(answers)


def unconfigured(answers: Answers) -> tuple[RequestedNode, ...]:
    """Return the nodes that wait, once started, for somebody to configure and activate them."""
    return tuple(node for node in lifecycle(answers) if node not in activated(answers))


def notes_on_launch(answers: Answers) -> list[str]:
    """Return what the user should hear of the launch file."""
    waiting = unconfigured(answers)
    if not waiting or not answers.launch:
        return []
    names = ", ".join(f"`{node.name}`" for node in waiting)
    return [
        f"launch files in {answers.launch.upper()} can't activate lifecycle nodes on {answers.distro.name}, so {names} "
        f"will wait for `ros2 lifecycle set /{waiting[0].name} configure` and `activate`; --launch py does it by itself"
    ]
