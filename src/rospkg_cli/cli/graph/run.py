"""`rospkg graph`: read the packages, run the rules on dependencies, and print what depends on what."""

from __future__ import annotations

import sys
from pathlib import Path

from ...engine.discovery.choose_configs import choose_configs
from ...engine.discovery.locate import Located, locate
from ...engine.run.pool import Pool
from ...engine.run.session import Session
from ...graph.as_dot import as_dot
from ...graph.as_html import as_html
from ...graph.as_json import as_json
from ...graph.as_list import as_list
from ...graph.as_mermaid import as_mermaid
from ...graph.build_graph import UNDECLARED, UNUSED, build_graph
from ...graph.workspace_graph import WorkspaceGraph
from ...light_dataclasses import dataclass, replace
from ...package.inspection import launch_files
from ...suggest import did_you_mean
from .. import UsageError
from ..lint.lint_options import LintOptions, RuleOptions
from ..lint.session import make_session
from ..progress import progress
from ..streams import say

WRITERS = {"list": as_list, "dot": as_dot, "mermaid": as_mermaid, "json": as_json, "html": as_html}


@dataclass(frozen=True)
class GraphOptions:
    paths: tuple[Path, ...] = ()
    format: str = "list"
    around: str | None = None
    depth: int = 1
    kinds: tuple[str, ...] = ()
    """Those of KINDS that are shown; all, if none is named."""
    outside: bool = False
    target: tuple[str, ...] = ()


def graph(options: GraphOptions) -> int:
    """Print the graph of the packages at some paths (the current folder, if none); return the exit status.

    Raises UsageError where there is no package, LocateError where there is no such path, and ConfigError.
    """
    paths = options.paths or (Path(),)
    configs = choose_configs(paths)
    located = locate(paths, None, configs)
    if not located.scope.selected:
        raise UsageError(nothing_there(paths, located))
    rules = RuleOptions(select=(*UNDECLARED, *UNUSED), pedantic=True, target=options.target)
    with progress(True) as show_progress:
        session = make_session(LintOptions(paths=paths, jobs="1", rules=rules), configs, located, show_progress)
        found, crashes = read_graph(replace(session, reports_switched_off=False))
    sys.stdout.writelines(f"{line}\n" for line in WRITERS[options.format](chosen(found, options)))
    for name in crashes:
        say(f"the dependencies of `{name}` are not all checked: internal error; `rospkg lint --traceback` shows more")
    return 3 if crashes else 0


def nothing_there(paths: tuple[Path, ...], located: Located) -> str:
    why = f": {located.hidden}" if located.hidden else ""
    names = ", ".join(f"`{path}`" for path in paths)
    return f"there is no package at {names}{why}; give the path of one"


def read_graph(session: Session) -> tuple[WorkspaceGraph, list[str]]:
    """Return the whole graph, and the packages in which a reader or a rule crashed."""
    pool = Pool(session.tree, session.scope, session.targets, session.settings)
    session.show_progress(f"reading {len(session.scope.folders)} packages")
    facts = sorted(pool.collect_facts(session.scope.folders), key=lambda each: each.folder)
    workspace = session.link(facts)
    launch = {folder: launch_files(pool.worker.packages[folder]) for folder in sorted(session.scope.selected)}
    session.show_progress(f"checking {len(session.scope.selected)} packages")
    results = session.collect(workspace, session.check(pool, workspace))
    results = session.filter_results(session, results)
    return build_graph(workspace, results.findings, launch), sorted({each.package for each in results.crashes})


def chosen(found: WorkspaceGraph, options: GraphOptions) -> WorkspaceGraph:
    """Return the part that is asked for; raises UsageError for a package that is not in it."""
    found = found if options.outside else found.without_outside()
    found = found.of_kinds(options.kinds) if options.kinds else found
    if options.around is None:
        return found
    names = [node.name for node in found.nodes if not node.is_launch_file]
    if options.around not in names:
        raise UsageError(f"there is no package `{options.around}` in the graph{did_you_mean(options.around, names)}")
    return found.around(options.around, options.depth)
