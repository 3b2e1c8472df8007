"""A rosdistro of our own making, as files; and a server of it that can fail in many ways."""

from __future__ import annotations

import threading
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer

DISTROS = ("humble", "jazzy", "kilted", "lyrical", "rolling")


def distribution(*packages: str) -> str:
    """Return a distribution file with one repository that releases some packages."""
    listed = "".join(f"      - {name}\n" for name in packages)
    return (
        "%YAML 1.1\n---\ntype: distribution\nversion: 2\nrelease_platforms: {ubuntu: [noble]}\nrepositories:\n"
        f"  things:\n    release:\n      tags: {{release: x}}\n      packages:\n{listed}      version: 1.0.0-1\n"
        "  alone:\n    release: {tags: {release: x}, version: 1.0.0-1}\n"
        "  unreleased:\n    source: {type: git, url: 'https://example.org/x.git', version: main}\n"
    )


def index(*distros: str) -> str:
    lines = [f"  {name}: {{distribution: [{name}/distribution.yaml], distribution_type: ros2}}" for name in distros]
    return "\n".join(["type: index", "version: 4", "distributions:", *lines, ""])


FILES: Mapping[str, str] = {
    "index-v4.yaml": index("noetic", *DISTROS),
    **{f"{name}/distribution.yaml": distribution("rclcpp", "rclpy", "wheel_odometry") for name in DISTROS},
    "humble/distribution.yaml": distribution("rclcpp", "rclpy", "wheel_odometry", "only_in_humble"),
    "rosdep/base.yaml": (
        "gripper-lib:\n  ubuntu: [libgripper-dev]\n"
        "old-lib:\n  ubuntu: {jammy: [libold-dev]}\n"
        "everywhere-pip:\n  '*': {pip: {packages: [everywhere]}}\n"
    ),
    "rosdep/python.yaml": "python3-gripper:\n  ubuntu: [python3-gripper]\n",
    "rosdep/osx-homebrew.yaml": "gripper-lib:\n  osx: {homebrew: {packages: [gripper]}}\nmac-only:\n  osx: [x]\n",
    "rosdep/sources.list.d/20-default.list": (
        "# the lists\n"
        "yaml https://raw.githubusercontent.com/ros/rosdistro/master/rosdep/osx-homebrew.yaml osx\n\n"
        "yaml https://raw.githubusercontent.com/ros/rosdistro/master/rosdep/base.yaml\n"
        "yaml https://raw.githubusercontent.com/ros/rosdistro/master/rosdep/python.yaml\n"
        "gbpdistro https://raw.githubusercontent.com/ros/rosdistro/master/releases/fuerte.yaml fuerte\n"
    ),
}


@dataclass
class Mirror:
    """What a server has, and what goes wrong with some of it."""

    files: dict[str, str]
    url: str = ""
    broken: dict[str, int | str] = field(default_factory=dict)
    """Path to a status; "cut" for a body that ends early, "stall" for one that never ends."""
    asked: list[str] = field(default_factory=list)
    stalled: threading.Event = field(default_factory=threading.Event)
    over: threading.Event = field(default_factory=threading.Event)


def answer(mirror: Mirror, request: BaseHTTPRequestHandler) -> None:
    path = request.path.partition("?")[0].lstrip("/")
    mirror.asked.append(request.path)
    wrong = mirror.broken.get(path, 200 if path in mirror.files else 404)
    body = mirror.files.get(path, "").encode()
    request.send_response(wrong if isinstance(wrong, int) else 200)
    request.send_header("Content-Length", str(len(body)))
    request.end_headers()
    if wrong == "stall":
        request.wfile.write(body[:20])
        request.wfile.flush()
        mirror.stalled.set()
        mirror.over.wait(30)
    elif wrong == "cut":
        request.wfile.write(body[: len(body) // 2])
    elif wrong == 200:
        request.wfile.write(body)


@contextmanager
def serve(files: Mapping[str, str] = FILES) -> Iterator[Mirror]:
    """Serve some files on this machine."""
    mirror = Mirror(dict(files))

    class Handler(BaseHTTPRequestHandler):
        def do_GET(self) -> None:  # the name is http.server's
            answer(mirror, self)

        def log_message(self, *_: object) -> None:
            """Keep quiet."""

    server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    mirror.url = f"http://127.0.0.1:{server.server_port}"
    threading.Thread(target=server.serve_forever, daemon=True).start()
    try:
        yield mirror
    finally:
        mirror.over.set()
        server.shutdown()
        server.server_close()
