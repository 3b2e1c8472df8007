"""Where rosdistro is: a folder, a file, or a URL; as typed, else as the environment and the user's config say."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from urllib.parse import SplitResult, urljoin, urlsplit, urlunsplit

from ..light_dataclasses import dataclass
from . import NamesError

DEFAULT = "https://raw.githubusercontent.com/ros/rosdistro/master/index-v4.yaml"
INDEX = "index-v4.yaml"
SCHEMES = ("http", "https", "file")


@dataclass(frozen=True)
class FileUrl:
    """The URL of an index file; what it names without a scheme is relative to it."""

    url: str

    def join(self, path: str) -> FileUrl:
        """Return the place of a path that is relative to the index file, or of a URL; a query goes with the former.

        Raises NamesError for what is neither, and for a file of this machine that another machine names.
        """
        parts, other = split(self.url), split(path)
        if other.scheme and (other.scheme not in SCHEMES or (other.scheme == "file" and parts.scheme != "file")):
            raise NamesError(f"{self} names `{path}`, and that is not read")
        if other.scheme:
            return FileUrl(path)
        return FileUrl(urljoin(urlunsplit(parts._replace(query="")), path) + (f"?{parts.query}" if parts.query else ""))

    def holds(self, other: FileUrl) -> bool:
        """Return whether another place lies in the folder of the index file."""
        folder = urlunsplit(urlsplit(self.url)._replace(query="", fragment="")).rpartition("/")[0]
        return other.url.startswith(folder + "/")

    def __str__(self) -> str:
        """The place as it may be shown: a folder's path, a URL without password and query."""
        parts = urlsplit(self.url)
        if parts.scheme == "file":
            return path_of(self.url)
        return urlunsplit(parts._replace(netloc=parts.netloc.rpartition("@")[2], query="", fragment=""))


def split(url: str) -> SplitResult:
    """Return the parts of a URL; raises NamesError where it is none."""
    try:
        return urlsplit(url)
    except ValueError as error:
        raise NamesError(f"`{url}` is no URL: {error}") from None


def path_of(url: str) -> str:
    from urllib.request import url2pathname

    return url2pathname(urlsplit(url).path)


def index_url(asked: str, environment: Mapping[str, str], configured: str) -> FileUrl:
    """Return the index file that was asked for, else $ROSDISTRO_INDEX_URL, else the config's, else ros/rosdistro's.

    Raises NamesError for what is neither a folder, a file nor a URL that can be read.
    """
    named = (
        (asked, "--source"),
        (environment.get("ROSDISTRO_INDEX_URL", ""), "ROSDISTRO_INDEX_URL"),
        (configured, "`index.source` of your config"),
        (DEFAULT, ""),
    )
    text, where = next((text, where) for text, where in named if text)
    scheme = split(text).scheme
    if "://" not in text and not text.startswith("file:"):
        return local(Path(text).expanduser(), where)
    if scheme not in SCHEMES:
        raise NamesError(f"{where}: `{text}` can't be read; there are {', '.join(SCHEMES)} URLs, and folders")
    if scheme == "file":
        return local(Path(path_of(text)), where)
    parts = urlsplit(text)
    if not parts.netloc:
        raise NamesError(f"{where}: `{text}` names no host")
    if parts.path.endswith((".yaml", ".yml")):
        return FileUrl(text)
    return FileUrl(urlunsplit(parts._replace(path=f"{parts.path.rstrip('/')}/{INDEX}")))


def local(path: Path, where: str) -> FileUrl:
    path = path.resolve()
    if path.is_dir():
        path = path / INDEX
        if not path.is_file():
            raise NamesError(f"{where}: `{path.parent}` is no copy of rosdistro: it has no {INDEX}")
    if not path.is_file():
        raise NamesError(f"{where}: there is no folder and no file `{path}`; give a copy of rosdistro, or its URL")
    return FileUrl(path.as_uri())


def shortened(place: FileUrl) -> FileUrl:
    """Return the folder around an index file of the usual name on this machine; any other place as it is."""
    url = place.url.removesuffix(f"/{INDEX}") if place.url.startswith("file:") else place.url
    return FileUrl(url)
