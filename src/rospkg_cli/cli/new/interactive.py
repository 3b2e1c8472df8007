"""`rospkg new --interactive`: a question for every option that was not given, each with its default."""

from __future__ import annotations

import shlex
import sys
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, fields, replace
from pathlib import Path
from typing import Any

from ...control_characters import visible
from ...ros.distros import DISTROS
from ...scaffold import ScaffoldError
from ...scaffold.answers import Request
from ...scaffold.launch_format import LAUNCH_FORMATS
from ...scaffold.maintainer import find_maintainer
from ...scaffold.names import check_package_name
from ...scaffold.node import default_nodes
from ...scaffold.plan import LAUNCH, LICENSE, TESTS, make_plan, template_of
from ...scaffold.resolve_request import distro_of
from ...scaffold.template import Template, template_names
from ...scaffold.test_level import TEST_LEVELS
from .. import UsageError
from ..streams import say

OPTIONS = {
    "template": "--type", "nodes": "--node", "msgs": "--msg", "srvs": "--srv", "actions": "--action",
    "extras": "--with", "own_template": "--template",
}  # fmt: skip
"""The options whose names differ from those of the request's fields."""


@dataclass(frozen=True)
class Question:
    field: str
    text: str
    default: Callable[[Request, Path], str] = lambda request, folder: ""
    """The default, written as an answer."""
    applies: Callable[[Template], bool] = lambda template: True
    each: bool = False
    """Whether it is asked again until the answer is empty, because an answer may contain commas."""


QUESTIONS = (
    Question("template", f"Type: {', '.join(template_names())}", lambda request, folder: request.template),
    Question(
        "nodes",
        "Nodes (comma-separated), as NAME or NAME:KIND",
        lambda request, folder: ",".join(default_nodes(request.name, template_of(request.template))),
        lambda template: bool(template.kinds),
    ),
    Question(
        "nodes", "Nodes to start (comma-separated), as PACKAGE/EXECUTABLE", applies=lambda template: template.starts
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
        f"Launch file: {', '.join(LAUNCH_FORMATS)}",
        lambda request, folder: LAUNCH,
        lambda template: template.launches,
    ),
    Question("tests", f"Tests: {', '.join(TEST_LEVELS)}", lambda request, folder: TESTS),
    Question(
        "distro",
        f"Distribution: {', '.join(each.name for each in DISTROS)}",
        lambda request, folder: distro_of("", []).name,
    ),
    Question("description", "Description, in one sentence", lambda request, folder: "from its content"),
    Question("license", "License (SPDX identifier)", lambda request, folder: LICENSE),
    Question("maintainer", "Maintainer", lambda request, folder: find_maintainer("", "", folder).name.text),
    Question("email", "E-mail", lambda request, folder: find_maintainer("", "", folder).email),
)


def ask(request: Request, folder: Path, defaults: Mapping[str, str]) -> Request:
    """Return the request with what was answered; raises UsageError where the answers end too soon."""
    while not request.name:
        request = answered(Question("name", "Package name"), request, lambda asked: check_package_name(asked.name), "")
    known = request.with_defaults(defaults)
    for question in QUESTIONS:
        template = template_of(request.template)
        typed = question.field != "template" and getattr(request, question.field)
        if typed or (question.field == "template" and request.template != Request.template):
            continue
        if request.own_template or not question.applies(template):
            continue
        default = str(getattr(known, question.field) or question.default(request, folder))
        request = all_answers(question, request, lambda asked: make_plan(asked, folder, defaults), default)
    return request


def all_answers(question: Question, request: Request, check: Callable[[Request], object], default: str) -> Request:
    found = answered(question, request, check, default)
    while question.each and found != request:
        request, found = found, answered(question, found, check, "")
    return found


def answered(question: Question, request: Request, check: Callable[[Request], object], default: str) -> Request:
    """Ask until there is an answer that holds; nothing answered leaves the request as it is."""
    while True:
        text = read_line(f"{question.text}{f' [{default}]' if default else ''}: ", question.text)
        if not text:
            return request
        value: Any = text
        if isinstance(getattr(request, question.field), tuple):
            more = (text,) if question.each else tuple(part.strip() for part in text.split(",") if part.strip())
            value = (*getattr(request, question.field), *more)
        asked = replace(request, **{question.field: value})
        try:
            check(asked)
        except ScaffoldError as error:
            say(str(error))
            continue
        return asked


def read_line(prompt: str, what: str) -> str:
    """Return one line from stdin; the prompt goes to stderr."""
    print(visible(prompt), end="", file=sys.stderr, flush=True)
    text = sys.stdin.readline()
    if not text:
        print(file=sys.stderr)
        raise UsageError(f"the answers ended at `{what}`; nothing was written")
    return text.strip()


def command_of(request: Request) -> str:
    """Return the command that asks for the same without questions."""
    return shlex.join(["rospkg", "new", request.name, *words_of(request)])


def words_of(request: Request) -> Iterator[str]:
    for field in fields(request):
        value = getattr(request, field.name)
        if field.name == "name" or value == field.default:
            continue
        if field.name == "params":
            yield "--no-params"
            continue
        for each in value if isinstance(value, tuple) else (str(value),):
            yield from (OPTIONS.get(field.name, f"--{field.name}"), each)
