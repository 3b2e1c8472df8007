"""What was chosen for a package, in a few lines, before it is written."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from ...scaffold.node_kinds import shown
from ...scaffold.plan import Plan


def summary_lines(plan: Plan, into: Path) -> Iterator[str]:
    """Yield the folder and the type of a package, then a line for each kind of choice."""
    answers = plan.answers
    yield f"{into / answers.name}: {plan.template.name}, {answers.description.text}"
    nodes = [f"{node.name} ({node.kind.name}, {shown(node.language)})" for node in answers.nodes]
    choices = {
        "nodes": ", ".join(nodes),
        "plugins": ", ".join(f"{plugin.name} ({plugin.kind.name})" for plugin in answers.plugins),
        "interfaces": ", ".join(each.name for each in answers.interfaces),
        "depends on": ", ".join(answers.depends),
        "launch file": answers.launch,
        "parameters": "generated" if any(node.definitions for node in answers.nodes) else "",
        "tests": answers.tests,
        "with": ", ".join(plan.asked.extras),
        "for": f"ROS 2 {answers.distro.name}",
        "license": answers.license.spdx,
        "maintainer": f"{answers.maintainer.text} <{answers.email}>",
    }
    for name, chosen in choices.items():
        if chosen:
            yield f"  {name:<12} {chosen}"
