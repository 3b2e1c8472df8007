"""Nodes as they are asked for: `NAME`, `NAME:KIND`, `NAME:KIND:LANGUAGE`, `NAME:publisher:PACKAGE/Message@TOPIC`."""

from __future__ import annotations

import re
from collections.abc import Iterator

from . import ScaffoldError
from .interface_lookup import message_of
from .names import LONGEST, check_node_name
from .node_kinds import NodeKind, about, all_kinds, form_of, kind_of_message, named, offered_kinds, shown
from .node_words import node_words, unknown_word
from .qos import DEFAULT, QOS
from .requested_node import RequestedNode
from .several import PLUS, joined_node, part_texts
from .template import Template
from .workspace import WorkspacePackages


def nodes_of(
    asked: tuple[str, ...], package: str, template: Template, there: WorkspacePackages
) -> tuple[RequestedNode, ...]:
    """Return the nodes; where none was asked for, one of each language, with names made from the package's.

    Raises ScaffoldError for what the template can't write.
    """
    if template.starts:
        return ()
    if not template.kinds and asked:
        stem = re.sub(r"_(interfaces|description|bringup)$", "", package)
        command = f"rospkg new {stem}_nodes --node {asked[0]}"
        raise ScaffoldError(f"a package of this type has no nodes; give them one of their own: {command}")
    nodes: dict[str, RequestedNode] = {}
    for text in asked or default_nodes(package, template):
        node = node_of(text, package, template, there)
        if node.name in nodes:
            raise ScaffoldError(f"the node `{node.name}` is named twice; name each once")
        nodes[node.name] = node
    check_languages(tuple(nodes.values()), package, template)
    return tuple(nodes.values())


def node_of(text: str, package: str, template: Template, there: WorkspacePackages) -> RequestedNode:
    """Return one node; after its name, what it is may follow in any order, and after `+` what else it is."""
    if PLUS in text:
        return joined_node(text, [node_of(part, package, template, there) for part in part_texts(text)])
    words = node_words(text)
    name = words.name
    check_node_name(name, package)
    kind = all_kinds()[known_kind(words.kind, template)] if words.kind else all_kinds()[template.kinds[0]]
    if kind.name == "component" and f"{name}_component" == package:
        raise ScaffoldError(f"the library of `{name}` would have the name of its package; give the node another name")
    language = language_of(text, words.language, kind, template)
    if words.qos and form_of(kind) + "/" * bool(words.interface) != "msg/":
        raise ScaffoldError(
            f"`{text}`: {words.qos} is for the topic of a message: publisher:std_msgs/String:{words.qos}"
        )
    message = None
    if words.interface:
        of = kind_of_message(kind)
        message = message_of(words.interface, package, there, form_of(kind))
        kind = about(of, message.name, message.full_name, message.topic)
    if words.topic:
        kind = named(kind, words.topic)
    return RequestedNode(name, kind, language, message, QOS.get(words.qos, DEFAULT))


def language_of(text: str, asked: str, kind: NodeKind, template: Template) -> str:
    """Return the language of a node; raises ScaffoldError where the template or the kind has none of it."""
    fitting = [each for each in template.languages if each in kind.languages]
    language = asked or fitting[0]
    if language not in template.languages:
        other = "ament_cmake" if language == "cpp" else "ament_python"
        raise ScaffoldError(
            f"`{text}`: this type of package has no nodes in {shown(language)}; --type {other} or mixed"
        )
    if language not in kind.languages:
        raise ScaffoldError(
            f"`{text}`: {kind.name} nodes are available in {' and '.join(map(shown, kind.languages))} only"
        )
    return language


def known_kind(word: str, template: Template) -> str:
    """Return a kind that a template offers; raises ScaffoldError for one that it doesn't, or for an unknown one."""
    if word in template.kinds:
        return word
    offered = ", ".join(template.kinds)
    if word not in offered_kinds():
        hint = unknown_word(word, template.kinds)
        raise ScaffoldError(f"there is no kind of node `{word}`{hint}; known: {', '.join(offered_kinds())}")
    languages = all_kinds()[word].languages
    if set(languages).isdisjoint(template.languages):
        written = f"only in {' and '.join(map(shown, languages))}"
        here = " and ".join(map(shown, template.languages))
        raise ScaffoldError(f"a {word} can be written {written}, and `{template.name}` has nodes in {here}: {offered}")
    raise ScaffoldError(f"`{template.name}` offers no {word}; it offers: {offered}")


def check_languages(nodes: tuple[RequestedNode, ...], package: str, template: Template) -> None:
    """Raise ScaffoldError where a package for several languages would have nodes in one."""
    used = {node.language for node in nodes}
    for missing in sorted(set(template.languages) - used) if used else ():
        [only] = used
        alone = {"cpp": "ament_cmake", "python": "ament_python"}[only]
        raise ScaffoldError(
            f"every node is in {shown(only)}, which --type {alone} is for; a {template.name} package has one in "
            f"{shown(missing)} too: --node NAME:{missing}"
        )


def default_nodes(package: str, template: Template) -> Iterator[str]:
    """Yield what is written where no node was asked for."""
    if template.kinds:
        yield default_node(package)
    if len(template.languages) > 1:
        yield f"{'listener' if package not in ('listener', 'listener_node') else 'hearer'}:subscriber:python"


def default_node(package: str) -> str:
    if package.endswith("_node"):
        return package.removesuffix("_node")
    return f"{package}_node" if len(package) <= LONGEST - len("_node") else "main_node"
