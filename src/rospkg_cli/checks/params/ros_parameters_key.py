"""PRM001: a missing or misspelt `ros__parameters:` below the name of a node."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from functools import cached_property

from ...files import PackageFiles
from ...languages.yaml.nodes import MappingNode, ScalarNode
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.launch.text import uncommented
from ...package.package_facts import PackageFacts
from ...package.params.named_yaml import ANY
from ...package.params.parameter_file import KEY, ParameterFile, is_key
from ...package.workspace import Workspace
from ...ros.share_layout import LAUNCH
from ...source import Source, Span
from ..enumeration import in_ticks
from ..fault import Fault, TextRepair, joined
from .rcl_validation import REFUSES

STARTING = regex(r"\.(?:py|xml|launch|launch\.ya?ml|sh|bash|[ch]pp|cc|service)$")
"""Files that give parameter files to nodes."""
PARSES = regex(r"\bYAML\s*\(|\byaml\.load|\b(?:safe|full|unsafe)_load\s*\(")
COMMENT = regex(r"[ \t]*(?:#.*)?\r?")
DOCS = regex(r"\.(?:md|rst|txt)$")
SHOWN = regex(r"(?:^|[_.-])(?:examples?|samples?|templates?)[_.-]")
"""How a file is called that is there to be copied."""
REWRITES = "RewrittenYaml"
"""Of nav2_common: it fills in values of a parameter file."""
TITLE = f"write `{KEY}:`"


@dataclass(frozen=True)
class ParameterFileUse:
    """A parameter file, among the packages whose launch files may use it."""

    file: ParameterFile
    workspace: Workspace
    package: PackageFacts
    files: PackageFiles

    @property
    def is_parsed_by_launch(self) -> bool:
        """Whether a launch file, or else code, parses it: then what is there for others needs no block."""
        name = self.file.path.rpartition("/")[2]
        return bool(self.workspace.having("parsed_yaml", name)) or self.is_parsed_by_code(name)

    def is_parsed_by_code(self, name: str) -> bool:
        """Return whether Python parses YAML and names the file, and no launch file does."""
        texts = {path: self.read(path) for path in self.files.paths if STARTING.search(path)}
        naming = {path: text for path, text in texts.items() if name in text}
        if any(LAUNCH.fullmatch(path.rpartition("/")[2]) for path in naming):
            return False
        return any(PARSES.search(text) for path, text in naming.items() if path.endswith(".py"))

    @cached_property
    def is_unnamed(self) -> bool:
        """Whether nothing names it: not the package, and no other that may give it to a node.

        That counts where nodes are launched, or the file is not installed, or called an example. A README names it
        where it tells to start a node with it.
        """
        launches = any(LAUNCH.fullmatch(path.rpartition("/")[2]) for path in self.files.paths)
        launches = launches or any(facts.launch_files for facts in self.workspace.packages)
        folder, _, name = self.file.path.rpartition("/")
        if not (launches or self.is_left_out or SHOWN.search(name)):
            return False
        stem = re.compile(rf"[\"'/]{re.escape(name.rpartition('.')[0])}[\"'.]")
        paths = [path for path in self.files.paths if path.endswith(f"/{name}") and path != self.file.path]
        others = [posixpath.dirname(path) for path in paths]
        told = re.compile(rf"params[-_]file\S*[ \t]*\S*{re.escape(name)}")
        for path in self.files.paths:
            wanted = stem if STARTING.search(path) else told if DOCS.search(path) else None
            if wanted is None or not wanted.search(text := self.read(path)):
                continue
            if named_in(folder, name, text) or not any(
                named_in(posixpath.dirname(each), name, text) for each in others
            ):
                return False
        return not self.is_named_elsewhere(name.rpartition(".")[0])

    def is_named_elsewhere(self, stem: str) -> bool:
        """Return whether another package may give the file to a node: it needs this one and names the file, or puts
        names together, or it names a file that it does not have itself."""
        own, ends = self.package.name, (f"/{stem}.yaml", f"/{stem}.yml")
        needing = {facts.name for facts in self.workspace.needing(own)}
        for facts in (each for each in self.workspace.packages if each.name != own):
            if facts.name in needing and not facts.named_yaml.isdisjoint((stem, ANY)):
                return True
            files = (*facts.share_files, *facts.uninstalled) if stem in facts.named_yaml else ends
            if not any(f"/{path}".endswith(ends) for path in files):
                return True
        return False

    @cached_property
    def rewriting(self) -> tuple[str, ...]:
        """The launch files of the package that write parameter files anew before nodes read them."""
        paths = (path for path in self.files.paths if LAUNCH.fullmatch(path.rpartition("/")[2]))
        return tuple(text for path in paths if REWRITES in (text := self.read(path)))

    def is_rewritten(self, span: Span) -> bool:
        """Return whether a launch file may give the parameter at a place another value (RewrittenYaml)."""
        name = re.compile(rf"[\"'.]{re.escape(self.file.source.slice(span))}[\"']")
        return any(map(name.search, self.rewriting))

    @property
    def is_left_out(self) -> bool:
        """Whether the package is known not to install the file."""
        return self.package.knows("share_files") and self.file.path not in self.package.share_files

    def read(self, path: str) -> str:
        text = self.files.readable_text(path)
        return uncommented(path, text) if LAUNCH.fullmatch(path.rpartition("/")[2]) else text


def named_in(folder: str, name: str, text: str) -> bool:
    """Return whether a text names a file together with its folder, as one path or in parts."""
    parts = rf"\b{re.escape(posixpath.basename(folder))}[\"'/,\s]+{re.escape(name.rpartition('.')[0])}\b"
    return re.search(parts, text) is not None


def key_faults(file: ParameterFile, *, is_parsed_by_launch: bool = False) -> Iterator[Fault]:
    """Yield each misspelt key, and the blocks without one as one fault: rcl refuses the file at the first."""
    lacking: list[tuple[str, Fault]] = []
    for entry in file.entries:
        key, value = entry.key, entry.value
        if not isinstance(key, ScalarNode):
            continue
        if entry.kind == "block" and not is_key(key):
            repair = TextRepair(TITLE, ((key.span, KEY),))
            yield Fault(key.span, f"`{key.text}` is written `{KEY}`, with two `_`; {REFUSES}", repair=repair)
        elif entry.kind == "no block" and isinstance(value, MappingNode) and not is_parsed_by_launch:
            lacking.append((key.text, Fault(key.span, "", repair=added_key(file.source, key, value))))
    if lacking:
        blocks = in_ticks(name for name, _ in lacking)
        start = f"the block of {blocks} has" if len(lacking) == 1 else f"the blocks of {blocks} have"
        yield joined([fault for _, fault in lacking], f"{start} no `{KEY}:` above the values; {REFUSES}", TITLE)


def added_key(source: Source, key: ScalarNode, value: MappingNode) -> TextRepair | None:
    """Return the repair that writes `ros__parameters:` above a block; None where the block is in braces.

    It may be a namespace that was intended.
    """
    text, first = source.text, value.entries[0][0].span.start
    start = text.rfind("\n", 0, first) + 1
    if text[value.span.start] == "{" or text[start:first].strip() or start <= key.span.end:
        return None
    end = first + len(text[first : value.span.end].rstrip())
    indent = text[start:first]
    while (last := text.rfind("\n", start, end)) != -1 and COMMENT.fullmatch(text, last + 1, end):
        if len(text[last + 1 : end]) - len(text[last + 1 : end].lstrip()) >= len(indent):
            break  # a comment of the block
        end = len(text[:last].rstrip())
    lines = [f"  {line}" if line.strip() else line for line in text[start:end].split("\n")]
    return TextRepair(TITLE, ((Span(start, end), "\n".join([f"{indent}{KEY}:", *lines])),), is_certain=False)
