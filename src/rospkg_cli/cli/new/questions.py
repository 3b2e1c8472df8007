"""The questions of `rospkg new --interactive`, with what may be answered and the defaults."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path

from ...light_dataclasses import dataclass
from ...ros.distros import DISTROS, Distro
from ...scaffold.answers import Request
from ...scaffold.extras import extras_with_meaning
from ...scaffold.generated_parameters import PARAMETER_FORMS
from ...scaffold.launch_format import formats_for
from ...scaffold.maintainer import find_maintainer
from ...scaffold.node import default_nodes
from ...scaffold.node_kinds import all_kinds
from ...scaffold.plan import LAUNCH, LICENSE, TESTS, template_of
from ...scaffold.plugin_kinds import plugin_kinds, plugin_title
from ...scaffold.resolve_request import distro_of
from ...scaffold.template import Template, load_template, template_names
from ...scaffold.test_level import TEST_LEVELS


def types() -> dict[str, str]:
    """Return the types of packages, each with its title as the rest of a sentence."""
    titles = {name: load_template(name).title for name in template_names()}
    return {name: title[:1].lower() + title[1:] for name, title in titles.items()}


def about_distro(distro: Distro) -> str:
    """Return what a distribution is for, and for how long."""
    end = f"until {distro.end_of_life}" if distro.end_of_life else "always the newest"
    end = f"an LTS {end}" if distro.lts else end
    return f"{distro.title} on Ubuntu {distro.ubuntu}, {end}"


@dataclass(frozen=True)
class Question:
    field: str
    text: str
    default: Callable[[Request, Path], str] = lambda request, folder: ""
    """The default, written as an answer."""
    applies: Callable[[Template], bool] = lambda template: True
    choices: Callable[[Template], Mapping[str, str]] = lambda template: {}
    """What may be answered, with what each means; listed before the question."""
    each: bool = False
    """Whether it is asked again until the answer is empty, because an answer may contain commas."""


QUESTIONS = (
    Question("template", "Type", lambda request, folder: request.template, choices=lambda template: types()),
    Question(
        "nodes",
        "Nodes (comma-separated), as NAME or NAME:KIND",
        lambda request, folder: ",".join(default_nodes(request.name, template_of(request.template))),
        lambda template: bool(template.kinds),
        lambda template: {kind: f"a node that {all_kinds()[kind].does}" for kind in template.kinds},
    ),
    Question(
        "nodes", "Nodes to start (comma-separated), as PACKAGE/EXECUTABLE", applies=lambda template: template.starts
    ),
    Question(
        "plugins",
        "Plugins (comma-separated), as KIND or NAME:KIND",
        lambda request, folder: plugin_kinds()[0],
        lambda template: template.plugins,
        lambda template: {kind: plugin_title(kind) for kind in plugin_kinds()},
    ),
    Question(
        "msgs",
        "A message, as NAME or NAME:FIELDS (empty to go on)",
        lambda request, folder: "" if request.msgs or request.srvs or request.actions else "Status",
        lambda template: template.interfaces,
        each=True,
    ),
    Question("depends", "Dependencies: packages and rosdep keys (comma-separated)"),
    Question(
        "launch",
        "Launch file",
        lambda request, folder: LAUNCH,
        lambda template: template.launches,
        formats_for,
    ),
    Question(
        "parameters",
        "Parameters",
        lambda request, folder: "file",
        lambda template: template.generates,
        lambda template: PARAMETER_FORMS,
    ),
    Question("tests", "Tests", lambda request, folder: TESTS, choices=lambda template: TEST_LEVELS),
    Question(
        "distro",
        "Distribution",
        lambda request, folder: distro_of("", []).name,
        choices=lambda template: {each.name: about_distro(each) for each in DISTROS},
    ),
    Question("description", "Description, in one sentence", lambda request, folder: "from its content"),
    Question("license", "License (SPDX identifier)", lambda request, folder: LICENSE),
    Question("maintainer", "Maintainer", lambda request, folder: find_maintainer("", "", folder).name.text),
    Question("email", "E-mail", lambda request, folder: find_maintainer("", "", folder).email),
    Question("extras", "What else (comma-separated)", choices=lambda template: extras_with_meaning()),
)
