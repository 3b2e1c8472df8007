"""Accounts that containers and machines have, by short names too: whose homes are nobody's own."""

from __future__ import annotations

from rospkg_cli.example import Example

from .setups import python

PEOPLE = {"data/people.txt": "Ada\n"}


def of(user: str, **files: str) -> Example:
    """A path in the home of an account, beside files that name it."""
    named = {path.replace("__", "/").replace("_DOT_", "."): text for path, text in files.items()}
    place = f"/home/{user}/ws/src/my_pkg/data/people.txt"
    return python({**PEOPLE, **named, "my_pkg/talker.py": f"open('«{place}»')\n"})


CASES = {
    "DEP118": (
        of("neo", docker__Dockerfile="FROM ros:jazzy\nRUN useradd -m -s /bin/bash neo\n"),
        of("neo", docker__robot_DOT_dockerfile="USER neo\n"),
        of("neo", docker__Dockerfile_DOT_jazzy="WORKDIR /home/neo/ws\n"),
        of("neo", _DOT_devcontainer__devcontainer_DOT_json='{"remoteUser": "neo"}\n'),
        of("neo", docker__start_DOT_sh="cd /home/neo/ws && colcon build\n"),
        of("neo", Vagrantfile="config.vm.synced_folder '.', '/home/neo/ws'\n"),
        of("neo", ansible__robot_DOT_yml="- hosts: all\n  remote_user: neo\n"),
        # another word, a folder of one's own on the host, or a script of one's own: on one machine still
        of("neo", docker__Dockerfile="RUN apt-get install -y neofetch # /home/neon\n"),
        of("neo", docker__compose_DOT_yaml="services:\n  a:\n    volumes:\n      - /home/neo/ws:/ws\n"),
        of("neo", scripts__a_DOT_sh="cd /home/neo/ws\n"),
    ),
}
