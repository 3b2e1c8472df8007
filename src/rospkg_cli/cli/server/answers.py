"""What the server answers about a place: where it is defined, what it is, what may follow, how it is formatted."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

from lsprotocol import types

from .formatting import formatting
from .language_server import PackageServer, path_of
from .live_workspace import package_of
from .navigation import Navigation

T = TypeVar("T")


def offer_lookups(server: PackageServer) -> None:
    """Let the server answer questions about places, each from the texts that are in the editor now."""

    @server.feature(types.TEXT_DOCUMENT_DEFINITION)
    def definition(asked: types.DefinitionParams) -> list[types.Location]:
        return at_place(server, asked, Navigation.definition) or []

    @server.feature(types.TEXT_DOCUMENT_HOVER)
    def hover(asked: types.HoverParams) -> types.Hover | None:
        return at_place(server, asked, Navigation.hover)

    @server.feature(
        types.TEXT_DOCUMENT_COMPLETION, types.CompletionOptions(trigger_characters=[">", "'", '"', "=", "/", " "])
    )
    def completion(asked: types.CompletionParams) -> types.CompletionList | None:
        return at_place(server, asked, Navigation.completion)

    @server.feature(types.TEXT_DOCUMENT_FORMATTING)
    def formatted(asked: types.DocumentFormattingParams) -> list[types.TextEdit]:
        uri = asked.text_document.uri
        if not uri.endswith("/package.xml"):
            return []
        return formatting(server.workspace.get_text_document(uri).source, server.workspace.position_codec)


def at_place(
    server: PackageServer,
    asked: types.DefinitionParams | types.HoverParams | types.CompletionParams,
    answer: Callable[[Navigation, str, str, types.Position], T],
) -> T | None:
    """Return an answer about a place of a file of a package; None where there is no package or nothing is known yet."""
    path = path_of(asked.text_document.uri)
    live = server.workspace_at(path) if path else None
    world = live.world() if live else None
    if path is None or live is None or world is None:
        return None
    folder = package_of(path, live.root, [each.folder for each in world.workspace.packages])
    if folder is None:
        return None
    navigation = Navigation(world, live.root, server.workspace.position_codec)
    return answer(navigation, folder, path.relative_to(live.root).as_posix(), asked.position)
