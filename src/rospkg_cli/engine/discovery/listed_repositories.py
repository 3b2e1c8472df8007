"""The repositories that a `.repos` file of vcs or a `.rosinstall` of wstool lists."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.yaml.nodes import MappingNode, ScalarNode, SequenceNode, YamlNode, documents
from ...source import Source

MAX_LISTED = 1_000


def listed_repositories(data: bytes) -> list[str]:
    """Return the folders of the listed repositories, relative to where they are checked out.

    vcs has `repositories:` with a mapping, wstool a sequence of mappings with a `local-name`. Raises UnreadableError,
    and ValueError for what is no list or a very long one.
    """
    roots = documents(Source("list", data.decode("utf-8")))
    found = [name for root in roots for name in names_in_list(root)]
    if not roots or len(found) > MAX_LISTED:
        raise ValueError("no list of repositories, or one too long")
    return found


def names_in_list(root: YamlNode) -> Iterator[str]:
    if isinstance(root, SequenceNode):
        for item in root.items:
            for _, repository in item.entries if isinstance(item, MappingNode) else ():
                yield from (value.text for value in values(repository, "local-name") if isinstance(value, ScalarNode))
        return
    for repositories in values(root, "repositories"):
        for key, _ in repositories.entries if isinstance(repositories, MappingNode) else ():
            if isinstance(key, ScalarNode):
                yield key.text


def values(node: YamlNode, wanted: str) -> Iterator[YamlNode]:
    """Yield the values of a key of a mapping."""
    for key, value in node.entries if isinstance(node, MappingNode) else ():
        if isinstance(key, ScalarNode) and key.text == wanted:
            yield value
