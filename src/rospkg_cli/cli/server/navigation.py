"""Definitions, hovers and completions, from the packages as they are in the editor."""

from __future__ import annotations

from pathlib import Path

from lsprotocol import types
from pygls.workspace import PositionCodec

from ...light_dataclasses import dataclass
from ...lookup.completion import completions
from ...lookup.definition import definitions
from ...lookup.hover import hover
from ...lookup.mention import Mention, mention_at
from ...lookup.world import DefinitionSite, LookupWorld
from .positions import span_range, to_offset


@dataclass
class Navigation:
    """What can be looked up in a workspace as it is now."""

    world: LookupWorld
    root: Path
    codec: PositionCodec

    def mention(self, folder: str, path: str, at: types.Position) -> Mention | None:
        """Return what stands at a position of a file; paths are relative to the root."""
        offset = to_offset(self.codec, self.world.source(path), at)
        return mention_at(self.world.package(folder), self.inner(folder, path), offset)

    def inner(self, folder: str, path: str) -> str:
        return path.removeprefix(f"{folder}/") if folder else path

    def definition(self, folder: str, path: str, at: types.Position) -> list[types.Location]:
        mention = self.mention(folder, path, at)
        found = definitions(self.world, folder, mention) if mention else []
        return [self.location(each) for each in found]

    def location(self, place: DefinitionSite) -> types.Location:
        at = self.range(place.path, place.span.start, place.span.end)
        return types.Location((self.root / place.path).as_uri(), at)

    def hover(self, folder: str, path: str, at: types.Position) -> types.Hover | None:
        mention = self.mention(folder, path, at)
        text = hover(self.world, folder, mention) if mention else ""
        if not mention or not text:
            return None
        content = types.MarkupContent(types.MarkupKind.Markdown, text)
        return types.Hover(content, self.range(path, mention.span.start, mention.span.end))

    def completion(self, folder: str, path: str, at: types.Position) -> types.CompletionList:
        source = self.world.source(path)
        offset = to_offset(self.codec, source, at)
        typed, names = completions(self.world, folder, self.inner(folder, path), source.text, offset)
        where = span_range(self.codec, source, offset - typed, offset)
        items = [types.CompletionItem(name, text_edit=types.TextEdit(where, name)) for name in names]
        return types.CompletionList(is_incomplete=True, items=items)

    def range(self, path: str, start: int, end: int) -> types.Range:
        return span_range(self.codec, self.world.source(path), start, end)
