"""What the server answers about a place: where it is defined, what it is, what may follow, how it is formatted."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TypeVar

from lsprotocol import types
from pygls.workspace import PositionCodec

from .formatting import formatting
from .language_server import PackageServer
from .live_lint import Scene
from .live_world import LiveWorld
from .navigation import Navigation
from .open_text import OpenText
from .open_workspaces import path_of
from .text_overlay import package_of

T = TypeVar("T")

Answer = Callable[[Navigation, str, str, types.Position], T]


def offer_lookups(server: PackageServer) -> None:
    """Let the server answer questions about places, each from the texts that are in the editor now."""

    @server.feature(types.TEXT_DOCUMENT_DEFINITION)
    async def definition(asked: types.DefinitionParams) -> list[types.Location]:
        return await server.in_time(at_place(server, asked, Navigation.definition)) or []

    @server.feature(types.TEXT_DOCUMENT_HOVER)
    async def hover(asked: types.HoverParams) -> types.Hover | None:
        return await server.in_time(at_place(server, asked, Navigation.hover))

    @server.feature(
        types.TEXT_DOCUMENT_COMPLETION, types.CompletionOptions(trigger_characters=[">", "'", '"', "=", "/", " "])
    )
    async def completion(asked: types.CompletionParams) -> types.CompletionList | None:
        return await server.in_time(at_place(server, asked, Navigation.completion))

    @server.feature(types.TEXT_DOCUMENT_FORMATTING)
    async def formatted(asked: types.DocumentFormattingParams) -> list[types.TextEdit]:
        uri = asked.text_document.uri
        if not uri.endswith("/package.xml"):
            return []
        text, codec = server.workspace.get_text_document(uri).source, server.workspace.position_codec
        return await server.in_time(looked_up(server, formatting, text, codec))


async def at_place(
    server: PackageServer,
    asked: types.DefinitionParams | types.HoverParams | types.CompletionParams,
    answer: Answer[T | None],
) -> T | None:
    """Return an answer about a place of a file of a package; None where there is no package or no answer."""
    path = path_of(asked.text_document.uri)
    live = server.workspaces.at(path) if path else None
    if path is None or live is None:
        return None
    await server.lints.until(lambda: live.scene is not None or live.has_failed)
    if live.scene is None:
        return None
    codec, texts = server.workspace.position_codec, dict(live.texts)
    try:
        return await looked_up(server, look_up, live.world, live.scene, texts, codec, path, asked.position, answer)
    except Exception:
        server.crashed(live, path, answer.__name__)
        return None


async def looked_up(server: PackageServer, call: Callable[..., T], *given: object) -> T:
    """Return what a call returns in the thread of lookups, while runs wait."""
    with server.way.taken():
        return await asyncio.get_running_loop().run_in_executor(server.looking_up, call, *given)


def look_up(
    live: LiveWorld,
    scene: Scene,
    texts: Mapping[Path, OpenText],
    codec: PositionCodec,
    path: Path,
    position: types.Position,
    answer: Answer[T],
) -> T | None:
    """Return an answer from the packages as they are now; None for a file of none of them."""
    world = live.at(scene, texts)
    folder = package_of(path, scene.root, [each.folder for each in world.workspace.packages])
    if folder is None:
        return None
    inner = path.relative_to(scene.root).as_posix()
    return answer(Navigation(world, scene.root, codec), folder, inner, position)
