"""Where a new element of package.xml belongs: among its like, in their block, and not below a comment of others."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from ..languages.xml.elements import Element, XmlComment
from ..lazy_regex import regex
from ..package.manifest import Manifest
from ..ros.manifest import DEPENDENCY_TAGS, place_of

LINE_BREAK = regex(r"[ \t]*\n[ \t]*")
BLANK = regex(r"[ \t]*\n[ \t]*\n")
END = regex(r"\s*</package>")
DEPENDENCY = frozenset(DEPENDENCY_TAGS)
Block = list[Element]
"""Dependencies on lines that follow each other, without a blank line or a comment between them."""


def neighbour(manifest: Manifest, tag: str, name: str) -> tuple[Element | None, bool]:
    """Return the child next to which a new one belongs, and whether it comes before it; None in an empty package."""
    blocks = [block for block in blocks_of(manifest) if any(each.tag == tag for each in block)]
    if tag in DEPENDENCY_TAGS and blocks:
        return in_block(best(manifest, blocks, tag, name), tag, name)
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


def best(manifest: Manifest, blocks: Sequence[Block], tag: str, name: str) -> Block:
    """Return the block with its like, and most of a tag, of those that no comment gives a heading, if there are some.

    Packages of ROS are alike, and so are rosdep keys with a hyphen.
    """
    plain = [block for block in blocks if not has_heading(manifest, block)]

    def fits(block: Block) -> tuple[bool, int]:
        of_tag = [each for each in block if each.tag == tag]
        return any(("-" in each.text) == ("-" in name) for each in of_tag), len(of_tag)

    return max(plain or blocks, key=fits)


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
    """Return whether a comment stands in the line above a block; one that holds an element is no heading."""
    comment = comment_above(manifest, block[0])
    return comment is not None and not comment.text.strip().startswith("<")


def comment_above(manifest: Manifest, node: Element | XmlComment) -> XmlComment | None:
    """Return the comment that ends in the line above a node, and has its own lines."""
    nodes = manifest.root.nodes
    place = next(place for place, each in enumerate(nodes) if each is node)
    above = nodes[place - 1] if place else None
    text = manifest.source.text
    if not isinstance(above, XmlComment) or not LINE_BREAK.fullmatch(text[above.span.end : node.span.start]):
        return None
    line = manifest.source.line_span(manifest.source.position(above.span.start)[0])
    return above if not text[line.start : above.span.start].strip() else None


def behind_left_out(manifest: Manifest, element: Element, end: int) -> int:
    """Return where the comments right below an element end that leave out elements like it; `end` without one."""
    nodes = manifest.root.nodes
    place = next(place for place, each in enumerate(nodes) if each is element) + 1
    for node in nodes[place:]:
        is_next = LINE_BREAK.fullmatch(manifest.source.text[end : node.span.start]) is not None
        if not isinstance(node, XmlComment) or not is_next or not node.text.strip().startswith("<"):
            break
        end = node.span.end
    return end


def start_with_heading(manifest: Manifest, element: Element) -> int:
    """Return where an element begins, with the comments right above it."""
    first: Element | XmlComment = element
    while (above := comment_above(manifest, first)) is not None:
        first = above
    return first.span.start


def gap_before(manifest: Manifest, tag: str, following: Element) -> str:
    """Return the blank line that parts a new kind of dependency from the one behind it; "" where there is none."""
    return "\n" if tag in DEPENDENCY_TAGS and following.tag != tag and parts_kinds(manifest) else ""


def gap_behind(manifest: Manifest, tag: str, last: Element, at: int) -> str:
    """Return the blank line that parts a new kind of dependency, or <export>, from what is before it, or ""."""
    is_new = tag != last.tag and (tag in DEPENDENCY_TAGS or tag == "export")
    is_followed = BLANK.match(manifest.source.text, at) or (tag == "export" and END.match(manifest.source.text, at))
    return "\n" if is_new and is_followed and parts_kinds(manifest) else ""


def parts_kinds(manifest: Manifest) -> bool:
    """Return whether blank lines part each kind of dependency from its neighbours."""
    children = [child for child in manifest.root.children if child.tag not in ("group_depend", "member_of_group")]
    text = manifest.source.text
    between = [
        text[first.span.end : second.span.start]
        for first, second in pairwise(children)
        if first.tag != second.tag and not DEPENDENCY.isdisjoint((first.tag, second.tag))
    ]
    return bool(between) and all(BLANK.search(each) for each in between)


def is_sorted(elements: Sequence[Element]) -> bool:
    names = [element.text for element in elements]
    return names == sorted(names)


def rank(tag: str) -> tuple[int, int]:
    return place_of(tag), DEPENDENCY_TAGS.index(tag) if tag in DEPENDENCY_TAGS else 0
