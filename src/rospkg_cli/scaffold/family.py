"""The packages of a robot: its interfaces, its description, its nodes, and what starts them."""

from __future__ import annotations

import shutil
from collections.abc import Mapping, Sequence
from pathlib import Path

from ..engine.fixing.signals import signals_ignored, stopped_by_signals
from ..light_dataclasses import replace
from ..tree import MemoryTree
from . import ScaffoldError
from .answers import Request
from .family_root import FamilyRoot
from .maintainer import find_maintainer
from .names import LONGEST, check_package_name
from .node import default_nodes
from .plan import Plan, make_plan, template_of
from .target_folder import check_target
from .template import Template
from .workspace import workspace_packages
from .write import missing_parents, write_folder

OTHERS = ("interfaces", "description", "bringup")
"""The types of the other packages, which have no nodes; each has its type at the end of its name."""


def plan_family(request: Request, folder: Path, defaults: Mapping[str, str]) -> list[Plan]:
    """Return a plan for each package, every one after those that it depends on; raises as `make_plan` does."""
    template = template_of(request.template)
    check_family(request.name, template)
    merged = request.with_defaults(defaults)
    maintainer = find_maintainer(merged.maintainer, merged.email, folder)
    request = replace(request, maintainer=maintainer.name.text, email=maintainer.email)
    there, plans = workspace_packages(folder), []
    for each in members(request, template):
        plan = make_plan(each, folder, defaults, there)
        there = there.with_package(each.name, MemoryTree({file.path: file.entry for file in plan.files}))
        plans.append(plan)
    if maintainer.guessed:
        note = f"no e-mail address configured; using {maintainer.email} in every package.xml"
        plans[0] = replace(plans[0], notes=(*plans[0].notes, note + (" and setup.py" if has_setup(plans) else "")))
    return plans


def has_setup(plans: Sequence[Plan]) -> bool:
    return any(file.path == "setup.py" for plan in plans for file in plan.files)


def check_family(name: str, template: Template) -> None:
    check_package_name(name)
    if not template.kinds:
        raise ScaffoldError(
            f"--family writes the packages for interfaces, description and bringup itself; --type chooses that of "
            f"`{name}`, which has the nodes: ament_python, ament_cmake or mixed, not {template.name}"
        )
    for type in OTHERS:
        stem = name.removesuffix(f"_{type}")
        if stem != name:
            raise ScaffoldError(f"a family has the name of its robot: rospkg new {stem} --family")
        if len(f"{name}_{type}") > LONGEST:
            raise ScaffoldError(
                f"`{name}` is too long for a family: `{name}_{type}` has more than {LONGEST} characters"
            )


def members(request: Request, template: Template) -> list[Request]:
    """Return the requests for the packages, each with what it depends on."""
    name = request.name
    request = replace(request, extras=())
    plain = replace(request, nodes=(), depends=(), msgs=(), srvs=(), actions=(), description="", parameters="")
    plain = replace(plain, launch="" if request.launch == "none" else request.launch)
    nodes = request.nodes or own_nodes(request, template)
    used = any("/" in node or any(word[:1].isupper() for word in node.split(":")) for node in nodes)
    needs = () if used else (f"{name}_interfaces",)
    return [
        replace(
            plain,
            name=f"{name}_interfaces",
            template="interfaces",
            launch="",
            msgs=request.msgs,
            srvs=request.srvs,
            actions=request.actions,
        ),
        replace(plain, name=f"{name}_description", template="description"),
        replace(request, nodes=nodes, depends=request.depends + needs, msgs=(), srvs=(), actions=()),
        replace(plain, name=f"{name}_bringup", template="bringup", depends=(name, f"{name}_description")),
    ]


def own_nodes(request: Request, template: Template) -> tuple[str, ...]:
    """Return nodes that use the first message; none where there are services and actions alone."""
    if not request.msgs and (request.srvs or request.actions):
        return ()
    message = f"{request.name}_interfaces/{(request.msgs or ('Status',))[0].partition(':')[0]}"
    return tuple(f"{node}:{message}" for node in default_nodes(request.name, template))


def write_family(plans: Sequence[Plan], into: Path, root: FamilyRoot) -> None:
    """Write all packages into a folder, and what belongs to all of them, or nothing; raises ScaffoldError."""
    made, written = missing_parents(into / "any"), []
    for plan in plans:
        check_target(into, into / plan.answers.name)
    root.compared()
    with stopped_by_signals():
        try:
            for plan in plans:
                write_folder(into / plan.answers.name, plan.files)
                written.append(into / plan.answers.name)
            root.write()
        except BaseException:
            with signals_ignored():
                for folder in written:
                    shutil.rmtree(folder, ignore_errors=True)
                for folder in made:
                    if folder.is_dir() and not any(folder.iterdir()):
                        folder.rmdir()
            raise
