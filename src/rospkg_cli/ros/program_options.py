"""Options of programs that launch files start, over the supported distributions and Galactic."""

from __future__ import annotations

from ..light_dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class ProgramOptions:
    """What the parser of a program takes: argparse refuses anything else."""

    valued: frozenset[str]
    """Options that a value follows."""
    flags: frozenset[str]
    required: tuple[frozenset[str], ...] = ()
    """Of each group, one has to be given."""
    words: str = ""
    """What has to be given besides options, as its usage names it."""
    others: frozenset[str] = frozenset()
    """Options that take any number of values, behind which nothing is certain."""

    @property
    def all(self) -> frozenset[str]:
        return self.valued | self.flags | self.others


TRANSFORMS = ("tf2_ros", "static_transform_publisher")
NUMBERS = frozenset("--x --y --z --qx --qy --qz --qw --roll --pitch --yaw".split())
FRAMES = frozenset({"--frame-id", "--child-frame-id"})
ANGLES, QUATERNION = frozenset({"--roll", "--pitch", "--yaw"}), frozenset({"--qx", "--qy", "--qz", "--qw"})
SPAWNER = ProgramOptions(
    valued=frozenset(
        "-c --controller-manager -p --param-file -n --namespace -t --controller-type --controller-manager-timeout "
        "--switch-timeout --service-call-timeout".split()
    ),
    flags=frozenset(
        "-h --help --load-only --stopped --inactive -u --unload-on-kill --activate-as-group --switch-asap".split()
    ),
    words="the name of a controller",
    others=frozenset({"--controller-ros-args", "--controller"}),
)
ENTITY = ProgramOptions(
    valued=frozenset(
        "-file -topic -database -entity -reference_frame -gazebo_namespace -robot_namespace -timeout -wait "
        "-spawn_service_timeout -x -y -z -R -P -Y".split()
    ),
    flags=frozenset("-h --help -stdin -pause -unpause -package_to_model -b".split()),
    required=(frozenset({"-entity"}), frozenset({"-file", "-topic", "-database", "-stdin"})),
    others=frozenset({"-J"}),
)
PROGRAMS = {
    ("controller_manager", "spawner"): SPAWNER,
    ("controller_manager", "spawner.py"): SPAWNER,
    ("gazebo_ros", "spawn_entity.py"): ENTITY,
}
CREATE = ProgramOptions(
    valued=frozenset("world file param string topic name x y z R P Y".split()),
    flags=frozenset("allow_renaming noallow_renaming help helpfull helpshort helpxml version".split()),
    others=frozenset({"flagfile", "fromenv", "tryfromenv", "undefok"}),
)
"""The flags of ros_gz_sim's `create`, with one hyphen or two: it passes over any other."""
CREATORS = frozenset({("ros_gz_sim", "create"), ("ros_ign_gazebo", "create")})
OF_ENTITY = {"entity": "-name", "roll": "-R", "pitch": "-P", "yaw": "-Y", "r": "-R", "p": "-P"}
"""What `create` calls what others call so."""
