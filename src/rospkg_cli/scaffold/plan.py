"""What `rospkg new` would write, with notes and findings on it."""

from __future__ import annotations

import datetime
from collections.abc import Mapping, Sequence
from pathlib import Path

from ..finding import Finding, Severity
from ..light_dataclasses import dataclass, replace
from ..ros.interfaces import SEPARATORS
from . import OwnFaultError, ScaffoldError
from .answers import Answers, Request
from .bringup import Bringup, bringup_of
from .custom_template import custom_template
from .extras import notes_on_extras, with_extras
from .generated_parameters import generating, is_generating
from .launch_format import check_typed, launch_format, notes_on_launch
from .maintainer import Maintainer, check_for_cmake, find_maintainer
from .minimal import minimal_request, minimal_template
from .names import check_package_name
from .node import default_nodes, nodes_of
from .plugin import plugins_of
from .plugin_kinds import plugin_kinds
from .render import RenderedFile, render, render_line
from .resolve_request import depends_of, distro_of, license_of, requested_interfaces, version_of
from .self_lint import lint_written
from .short_words import closest_name
from .template import WORKSPACE, Template, load_template, template_names
from .test_level import test_level
from .user_text import UserText, user_text
from .workspace import WorkspacePackages, workspace_packages
from .wrong_depends import refuse_wrong_depends

LAUNCH = "py"
LICENSE = "Apache-2.0"
TESTS = "ament"
VERSION = "0.1.0"


@dataclass(frozen=True)
class Plan:
    answers: Answers
    template: Template
    files: tuple[RenderedFile, ...]
    commands: tuple[str, ...]
    """What to type next, from the root of the workspace."""
    findings: tuple[Finding, ...]
    """What our own linter says of what was asked for (an unknown key, say); never an error."""
    notes: tuple[str, ...]
    """What the user should hear: guesses, and what follows from what was asked for."""
    asked: Request
    """What was asked for, with what was taken where nothing was."""


def make_plan(
    request: Request, folder: Path, defaults: Mapping[str, str], there: WorkspacePackages | None = None
) -> Plan:
    """Return what would be written into a folder; raises ScaffoldError for what can't be, OwnFaultError.

    `defaults` holds a config's values by the names of the request's fields. What is missing there too comes from the
    environment, from git's config as it holds in the folder, and at last from the login. `there` are the packages
    around, if not those on disk.
    """
    if not request.own_template:
        return plan_with(template_of(request.template), request, folder, defaults, there)
    with custom_template(request.own_template) as template:
        return plan_with(template, request, folder, defaults, there)


def plan_with(
    template: Template, request: Request, folder: Path, defaults: Mapping[str, str], there: WorkspacePackages | None
) -> Plan:
    check_package_name(request.name)
    notes: list[str] = []
    check_typed(request.launch, template)
    request = minimal_request(request).with_defaults(defaults)
    maintainer = find_maintainer(request.maintainer, request.email, folder)
    if template.build_type == "ament_cmake":
        check_for_cmake(maintainer.name)
    template = with_extras(minimal_template(template, request), request.extras)
    notes.extend(notes_on_extras(request.extras, folder))
    there = (there or workspace_packages(folder)).without(request.name)
    answers = answers_of(request, maintainer, template, there, notes)
    files = render(template, answers)
    findings = lint_written(answers, files, there).findings
    refuse_errors(template, findings)
    refuse_wrong_depends(request.depends, findings)
    if maintainer.guessed:
        notes.append(where_guessed(maintainer, files))
    commands = tuple(render_line(template, line, answers) for line in template.commands)
    return Plan(answers, template, files, commands, findings, tuple(notes), understood(request, answers, template))


def understood(request: Request, answers: Answers, template: Template) -> Request:
    """Return a request that asks for the same on another day, in another place, and under another config."""
    return replace(
        request,
        nodes=request.nodes or tuple(default_nodes(request.name, template)),
        msgs=request.msgs or (("Status",) if template.interfaces and not (request.srvs or request.actions) else ()),
        plugins=request.plugins or (plugin_kinds()[:1] if template.plugins else ()),
        launch=(request.launch or LAUNCH) if template.launches else "",
        tests=answers.tests,
        license=answers.license.spdx,
        maintainer=answers.maintainer.text,
        email=answers.email,
        version=answers.version,
        distro=answers.distro.name,
        year=answers.year,
    )


def template_of(name: str) -> Template:
    known = template_names()
    if name in known:
        return load_template(name)
    offered = (*known, WORKSPACE)
    raise ScaffoldError(
        f"there is no type of package `{name}`{closest_name(name, offered)}; known: {', '.join(offered)}"
    )


def answers_of(
    request: Request, maintainer: Maintainer, template: Template, there: WorkspacePackages, notes: list[str]
) -> Answers:
    depends, test_depends = depends_of(request.depends, request.name)
    started = Bringup()
    if template.starts:
        started = bringup_of(request.name, request.nodes, depends, there, request.params)
        notes.extend(started.unknown)
    target = distro_of(request.distro, notes)
    nodes = nodes_of(request.nodes, request.name, template, there)
    answers = Answers(
        name=request.name,
        nodes=generating(nodes) if is_generating(request.parameters, template) else nodes,
        started=started,
        interfaces=requested_interfaces(request, template),
        depends=depends,
        test_depends=test_depends,
        description=user_text("the description", request.description),
        license=license_of(request.license or LICENSE),
        maintainer=maintainer.name,
        email=maintainer.email,
        version=version_of(request.version or VERSION),
        distro=target,
        year=request.year or datetime.date.today().year,
        launch=launch_format(request.launch or LAUNCH, template),
        params=request.params,
        tests=test_level(request.tests or TESTS),
        plugins=plugins_of(request.plugins, request.name, template, target.name),
    )
    if there.index.is_package(answers.name):
        notes.append(f"ROS has a released package `{answers.name}`; a workspace with yours will not use that one")
    if not answers.license.header_known and answers.tests == "ament":
        notes.append(f"ament_copyright knows no header for {answers.license.spdx}; its test was left out")
    notes += notes_on_launch(answers)
    if answers.description.text:
        return answers
    return replace(answers, description=UserText(render_line(template, template.description, answers)))


def refuse_errors(template: Template, findings: Sequence[Finding]) -> None:
    """Raise ScaffoldError for an error in what was asked for, OwnFaultError for any other."""
    faults = [finding for finding in findings if finding.severity is Severity.ERROR]
    for finding in faults:
        if finding.location.path.endswith(tuple(f".{form}" for form in SEPARATORS)):
            raise ScaffoldError(f"{finding.location.path.partition('/')[2]}: {finding.message}")
    if faults:
        shown = "; ".join(f"{each.location.path}:{each.location.line}: {each.code} {each.message}" for each in faults)
        raise OwnFaultError(f"`{template.name}` writes what our own linter refuses: {shown}")


def where_guessed(maintainer: Maintainer, files: Sequence[RenderedFile]) -> str:
    """Return a sentence that names the lines to change."""
    places = []
    for file in files:
        for number, line in enumerate(file.entry.text.text.splitlines(), 1):
            if maintainer.email in line:
                places.append(f"{file.path} line {number}")
    return f"no e-mail address configured; using {maintainer.email}; to change it: {' and '.join(places)}"
