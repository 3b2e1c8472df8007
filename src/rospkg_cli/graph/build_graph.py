"""From a run of lint to the graph: facts give the edges, findings and cycles mark them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from ..checks.workspace.dependency_cycles import needed, strongly_connected
from ..finding import Edit, Finding, Severity
from ..lazy_regex import regex
from ..light_dataclasses import replace
from ..package.launch.launch_file import LaunchFile
from ..package.package_facts import PackageFacts
from ..package.workspace import Workspace
from ..ros.interface_fields import known_interfaces
from ..ros.manifest import BUILDS, EXPORTED, NOT_ORDERED
from .launched import launch_node, launched
from .workspace_graph import KINDS, MARKS, EdgeKind, EdgeMark, GraphEdge, GraphNode, WorkspaceGraph

UNDECLARED = ("DEP101", "DEP102", "DEP103", "DEP104", "DEP105", "DEP106", "DEP108")
UNUSED = ("DEP202",)
ADVISED = regex(r"<(\w*depend)>([^<>]+)</\1>")
"""The line of package.xml that a rule on undeclared dependencies asks for, in its message and its fix."""

LaunchFiles = Mapping[str, tuple[LaunchFile, ...]]
"""Folder of a package → its launch files."""


class EdgeCollector:
    """Edges by source and target, while they are gathered from several places."""

    def __init__(self) -> None:
        self.kinds: dict[tuple[str, str], set[EdgeKind]] = {}
        self.marks: dict[tuple[str, str], set[EdgeMark]] = {}
        self.labels: dict[tuple[str, str], dict[str, None]] = {}

    def add(self, pair: tuple[str, str], kinds: Iterable[EdgeKind], label: str = "") -> None:
        if found := set(kinds):
            self.kinds.setdefault(pair, set()).update(found)
            self.labels.setdefault(pair, {}).update({label: None} if label else {})

    def mark(self, pair: tuple[str, str], mark: EdgeMark) -> None:
        if pair in self.kinds:
            self.marks.setdefault(pair, set()).add(mark)

    def edges(self) -> Iterator[GraphEdge]:
        for pair, kinds in sorted(self.kinds.items()):
            marks = tuple(mark for mark in MARKS if mark in self.marks.get(pair, ()))
            ordered = tuple(kind for kind in KINDS if kind in kinds)
            yield GraphEdge(*pair, ordered, ", ".join(self.labels[pair]), marks)


def build_graph(workspace: Workspace, findings: Iterable[Finding], launch: LaunchFiles) -> WorkspaceGraph:
    """Return the graph of the selected packages of a workspace, with all that they need beyond it."""
    edges = EdgeCollector()
    chosen = [facts for facts in workspace.packages if facts.folder in workspace.selected]
    for facts in chosen:
        add_dependencies(edges, facts, workspace)
    nodes = {facts.name: GraphNode(facts.name, facts.name) for facts in chosen}
    needed_nodes: dict[str, GraphNode] = {}
    for facts in chosen:
        for file in launch.get(facts.folder, ()):
            node = launch_node(facts.name, file.path)
            nodes[node.name] = node
            edges.add((facts.name, node.name), ("launch",))
            for target, label in launched(file, facts.name):
                edges.add((node.name, target.name), ("launch",), label)
                needed_nodes[target.name] = target
    mark_findings(edges, workspace, findings)
    add_interfaces(edges, workspace)
    needs = needed(workspace)
    for knot in strongly_connected(needs):
        for pair in [(one, other) for one in knot for other in needs[one] if other in knot]:
            edges.mark(pair, "cycle")
    for name in sorted({name for pair in edges.kinds for name in pair} - nodes.keys()):
        nodes[name] = replace(needed_nodes.get(name, GraphNode(name, name)), is_outside=True)
    return WorkspaceGraph(tuple(nodes[name] for name in sorted(nodes)), tuple(edges.edges()))


def add_dependencies(edges: EdgeCollector, facts: PackageFacts, workspace: Workspace) -> None:
    """Add what a manifest names, and the members of the groups that it depends on."""
    for need in facts.dependencies:
        edges.add((facts.name, need.name), kinds_of(need.tag))
    for group in facts.group_dependencies:
        for member in workspace.packages:
            if group.name in member.groups and member.name != facts.name:
                edges.add((facts.name, member.name), ("build", "exec"))


def add_interfaces(edges: EdgeCollector, workspace: Workspace) -> None:
    """Mark the dependencies on packages that define messages, services or actions, here or as ROS 2 is known to."""
    here = {facts.name for facts in workspace.packages}
    defining = {facts.name for facts in workspace.packages if facts.interfaces} | (known_interfaces().keys() - here)
    for (_, target), kinds in edges.kinds.items():
        if target in defining and kinds != {"launch"}:
            kinds.add("interface")


def kinds_of(tag: str) -> tuple[EdgeKind, ...]:
    """Return what a tag of package.xml makes a dependency for; nothing for documentation and for conflicts."""
    if tag in NOT_ORDERED:
        return ()
    if tag == "test_depend":
        return ("test",)
    if tag in ("depend", "run_depend"):
        return ("build", "exec") if tag in BUILDS else ("exec",)
    return ("build",) if tag in BUILDS | EXPORTED else ("exec",)


def mark_findings(edges: EdgeCollector, workspace: Workspace, findings: Iterable[Finding]) -> None:
    """Add the undeclared dependencies, marked, and mark those that nothing uses.

    What a declared one brings, or only some need, is an info of these rules: nothing fails, and nothing is marked.
    """
    for finding in findings:
        if finding.code in UNDECLARED and finding.severity is not Severity.INFO:
            for tag, name in advised(finding):
                edges.add((finding.package, name), kinds_of(tag))
                edges.mark((finding.package, name), "undeclared")
        elif finding.code in UNUSED and is_removed(finding):
            facts = workspace.at(finding.location.path.rpartition("/")[0])
            for need in facts.dependencies:
                if need.span == finding.location.span:
                    edges.mark((facts.name, need.name), "unused")


def advised(finding: Finding) -> set[tuple[str, str]]:
    """Return tag and name of what a finding asks to declare."""
    operations = finding.fix.operations if finding.fix else ()
    texts = [finding.message, *(each.text for each in operations if isinstance(each, Edit))]
    return {(found[1], found[2]) for text in texts for found in ADVISED.finditer(text)}


def is_removed(finding: Finding) -> bool:
    """Return whether the fix takes the dependency away; the other one keeps it for run time."""
    operations = finding.fix.operations if finding.fix else ()
    return all(isinstance(each, Edit) and not each.text.strip() for each in operations)
