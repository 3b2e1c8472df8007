"""`rospkg new my_ws --type workspace`: a folder for packages, with what all of them are built and checked with."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path

from ..light_dataclasses import field_names, replace
from ..ros.licenses import offered
from . import ScaffoldError
from .answers import Answers, Request
from .bringup import Bringup
from .extras import notes_on_extras, with_extras, workspace_extras
from .names import repaired
from .plan import LICENSE, TESTS, VERSION, Plan
from .render import render, render_line
from .resolve_request import distro_of
from .template import WORKSPACE, Template, load_template
from .user_text import UserText, user_text

NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9_.-]*")

LONGEST = 100

ANSWERED = ("name", "template", "extras", "description", "distro")
"""What may be asked of a workspace."""

WORDS = {"msgs": "messages", "srvs": "services", "own_template": "template of its own", "minimal": "minimal form"}


def plan_workspace(request: Request, folder: Path, defaults: Mapping[str, str]) -> Plan:
    """Return what would be written into a folder; raises ScaffoldError for what a workspace can't have."""
    check_asked(request)
    notes = list(notes_on_extras(request.extras, folder))
    template = with_extras(load_template(WORKSPACE), request.extras, workspace_extras())
    answers = answers_of_root(request, request.distro or defaults.get("distro", ""), template, notes)
    files = render(template, answers, {"repos": f"{request.name}.repos"})
    commands = tuple(render_line(template, line, answers) for line in template.commands)
    asked = replace(request, distro=answers.distro.name)
    return Plan(answers, template, files, commands, (), tuple(notes), asked)


def check_asked(request: Request) -> None:
    name, default = request.name, Request(request.name)
    if not NAME.fullmatch(name) or len(name) > LONGEST:
        better = repaired(name)
        hint = f"; try `{better}`" if better else ""
        raise ScaffoldError(f"`{name}` can't be the name of a workspace: letters, digits, `_`, `-` and `.`{hint}")
    for field in field_names(request):
        if field not in ANSWERED and getattr(request, field) != getattr(default, field):
            raise ScaffoldError(
                f"a workspace has no {WORDS.get(field, field)}; packages have: rospkg new {name}/src/my_robot"
            )


def answers_of_root(request: Request, distro: str, template: Template, notes: list[str]) -> Answers:
    license = offered(LICENSE)
    assert license is not None
    answers = Answers(
        name=request.name, nodes=(), started=Bringup(), interfaces=(), depends=(), test_depends=(),
        description=user_text("the description", request.description), license=license, maintainer=UserText(""),
        email="", version=VERSION, distro=distro_of(distro, notes), year=0, launch="", params=False, tests=TESTS,
    )  # fmt: skip
    if answers.description.text:
        return answers
    described = UserText(render_line(template, template.description, answers))
    return replace(answers, description=described)
