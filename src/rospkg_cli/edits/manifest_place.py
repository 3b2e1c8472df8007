"""Where a new element of package.xml belongs: among its like, in their block, and not below a comment of others."""

from __future__ import annotations

from collections.abc import Sequence

from ..languages.xml.elements import Element
from ..package.manifest import Manifest
from ..ros.manifest import DEPENDENCY_TAGS, place_of

Block = list[Element]
"""Dependencies on lines that follow each other, without a blank line or a comment between them."""


def neighbour(manifest: Manifest, tag: str, name: str) -> tuple[Element | None, bool]:
    """Return the child next to which a new one belongs, and whether it comes before it; None in an empty package."""
    blocks = [block for block in blocks_of(manifest) if any(each.tag == tag for each in block)]
    if tag in DEPENDENCY_TAGS and blocks:
        return in_block(best(manifest, blocks, tag), tag, name)
    if tag not in DEPENDENCY_TAGS and (like := manifest.all(tag)):
        return like[-1], False
    children = manifest.root.children
    order = rank if tag in DEPENDENCY_TAGS else place_of  # behind all dependencies, whatever order they have
    later = [child for child in children if child.tag in DEPENDENCY_TAGS and rank(child.tag) > rank(tag)]
    earlier = [child for child in children if rank(child.tag) < rank(tag)]
    last = max(earlier, key=lambda child: (order(child.tag), child.span)) if earlier else None
    if tag in DEPENDENCY_TAGS and later and (last is None or last.tag not in DEPENDENCY_TAGS):
        return later[0], True
    return last, False


def in_block(block: Block, tag: str, name: str) -> tuple[Element, bool]:
    """Return the place among those of a tag: by the alphabet where they are sorted, else behind the last."""
    like = [each for each in block if each.tag == tag]
    smaller = [each for each in like if each.text <= name]
    if not is_sorted(like):
        return like[-1], False
    return (smaller[-1], False) if smaller else (like[0], True)


def best(manifest: Manifest, blocks: Sequence[Block], tag: str) -> Block:
    """Return the block with most of a tag, of those that no comment gives a heading, where there are some."""
    plain = [block for block in blocks if not has_heading(manifest, block)]
    return max(plain or blocks, key=lambda block: sum(each.tag == tag for each in block))


def blocks_of(manifest: Manifest) -> list[Block]:
    found: list[Block] = []
    last: Element | None = None
    for child in manifest.root.children:
        if child.tag in DEPENDENCY_TAGS:
            if last is not None and is_next(manifest, last, child):
                found[-1].append(child)
            else:
                found.append([child])
        last = child if child.tag in DEPENDENCY_TAGS else None
    return found


def is_next(manifest: Manifest, first: Element, second: Element) -> bool:
    """Return whether nothing but a line break, and perhaps a comment in the first's own line, is between two."""
    between = manifest.source.text[first.span.end : second.span.start]
    same_line, _, rest = between.partition("\n")
    return not rest.strip() and "\n" not in rest and (not same_line.strip() or "-->" in same_line)


def has_heading(manifest: Manifest, block: Block) -> bool:
    """Return whether a comment stands in the line above a block."""
    before = manifest.source.text[: block[0].span.start].rstrip(" \t")
    above = before.removesuffix("\n").rpartition("\n")[2]
    return above.rstrip().endswith("-->") and above.lstrip().startswith("<!--")


def is_sorted(elements: Sequence[Element]) -> bool:
    names = [element.text for element in elements]
    return names == sorted(names)


def rank(tag: str) -> tuple[int, int]:
    return place_of(tag), DEPENDENCY_TAGS.index(tag) if tag in DEPENDENCY_TAGS else 0
