"""Fields of messages in Python code: which variables hold a message, and when nothing is said."""

from __future__ import annotations

from textwrap import indent

from rospkg_cli.example import INTERFACES_BODY, INTERFACES_CMAKE, Example, manifest, setup_py
from rospkg_cli.lazy_regex import regex

from .setups import python

IMPORTS = """\
from builtin_interfaces.msg import Time
from geometry_msgs.msg import Pose, PoseStamped, Twist
from my_ifs.action import Drive
from my_ifs.msg import Status
from my_ifs.srv import SetMode
import sensor_msgs.msg
from std_msgs.msg import Header, String
from std_srvs.srv import SetBool
"""
OTHERS = {
    "b/package.xml": manifest(INTERFACES_BODY, "ament_cmake").replace("my_pkg", "my_ifs"),
    "b/CMakeLists.txt": INTERFACES_CMAKE.replace("my_pkg", "my_ifs"),
    "b/msg/Status.msg": "uint8 IDLE=0\nfloat32 battery\ngeometry_msgs/Pose pose\nStatus2 next\nfloat32[] rates\n",
    "b/msg/Status2.msg": "string text\n",
    "b/srv/SetMode.srv": "string mode\n---\nbool success\n",
    "b/action/Drive.action": "float32 goal_x\n---\nbool done\n---\nfloat32 left\n",
}


def code(text: str) -> Example:
    """A file of a package, and a package of interfaces in the same workspace."""
    mine = {f"a/{path}": each for path, each in python({"my_pkg/talker.py": IMPORTS + text}).bad_files().items()}
    return Example(on="", bad={**mine, **OTHERS}, good={})


def body(text: str, start: str = "def f(self, msg):") -> str:
    return f"\n\n{start}\n{indent(text, '    ')}"


def node(init: str, methods: str) -> str:
    return f"\n\nclass Node:\n    def __init__(self):\n{indent(init, ' ' * 8)}\n{indent(methods, '    ')}"


def together(*parts: str) -> Example:
    """All in one file, with a number behind the names of classes, callbacks and of the misspelt field."""
    numbered = (NUMBERED.sub(rf"\g<0>{number}", part) for number, part in enumerate(parts))
    return code("".join(numbered))


NUMBERED = regex(r"\b(?:Node|hear|serve|batery)\b")
HEAR = "self.create_subscription(Status, 'status', self.hear, 10)\n"
SERVE = "self.create_service(SetMode, 'set_mode', self.serve)\n"

TICKS = "msg = Status()\nmsg.batery = 1\n"
TICKING = f"\n\nclass A:\n    def tick(self):\n{indent(TICKS, ' ' * 8)}"


def ticking(bases: str, init: str = "pass\n", name: str = "tick", before: str = "", end: str = "") -> Example:
    """A class of some bases with a method that sets a field that is not there."""
    start = f"\n\nclass Talker({bases}):\n    def __init__(self):\n{indent(init, ' ' * 8)}\n"
    return code(start + indent(f"{before}def {name}(self):\n{indent(TICKS, '    ')}", "    ") + end)


CAREFUL = "\n    def say(self):\n        try:\n            self.tick()\n        except Exception:\n            pass\n"
CASES = {
    "IDL010": (
        ticking("Node"),
        ticking("rclpy.node.Node", "# self.create_timer(1, self.tick)\npass\n"),
        ticking("Node", "self.create_timer(1, self.tick)\n"),
        ticking("Node", "getattr(self, 'tick')()\n"),
        ticking("Node", end="\n\ntick = 1\n"),
        ticking("Node", name="__call__"),
        ticking("Node", name="destroy_node"),
        ticking("Node", before="@timed\n"),
        ticking("Node, Mixin"),
        ticking("Mixin"),
        ticking("metaclass=Node"),
        ticking("Node", "msg = Status()\nmsg.batery = 2\n"),
        ticking("Node", "Status().batery\n"),
        code(body("try:\n    pass\nexcept ValueError:\n    Status().batery = 1\n", "def f():")),
        ticking("Node", end=CAREFUL),
        Example(
            on="",
            bad={
                **OTHERS,
                "a/package.xml": manifest("  <depend>my_ifs</depend>\n"),
                "a/setup.py": setup_py(),
                "a/test/test_a.py": f"{IMPORTS}\nmsg = Status()\nmsg.batery = 1.0\n",
            },
            good={},
        ),
        code(f"{TICKING}\n\nclass A:\n    pass\n"),
        code(f"\n\nclass A:\n    pass\n{TICKING}"),
        code("\nmsg = Status()\nmsg.idl = 1\nmsg.IDEL = 1\nprint(msg.idl, msg.IDL, Status(idl=1, IDL=1))\n"),
        code("\nmsg = Status()\nmsg.batery = 1\nmsg.unlike = 2\nmsg.pose.positon.x = 1.0\nmsg.next.texts = ''\n"),
        code(
            "\nmsg = Status()\nmsg.battery = msg.rates.batery = 1\nmsg._x = msg.SLOT_TYPES = msg.pose.position.x = 1\n"
        ),
        code(
            "\nprint(Status.IDEL, Status.IDLE, Status.battery, Status.batery, Status.BATTERY__DEFAULT, String.IDLE)\n"
        ),
        code("\nprint(Status(batery=1, **{}), Twist(liner=1), Twist(other=1), Pose(*a), Drive.Goal(goal_y=1))\n"),
        code(
            "\n"
            "goal = Drive.Goal()\n"
            "goal.goal_z = 1\n"
            "r = Drive.Result()\n"
            "r.don = 1\n"
            "f = Drive.Feedback()\n"
            "f.let = 1\n"
            "Drive.Impl().x\n"
        ),
        code(
            "\n"
            "q = SetMode.Request()\n"
            "q.mod = ''\n"
            "a = SetMode.Response()\n"
            "a.sucess = 1\n"
            "b = SetBool.Request()\n"
            "b.dat = 1\n"
            "SetMode().x\n"
        ),
        code(
            "\n"
            "msg = sensor_msgs.msg.Imu()\n"
            "msg.orientatio.x = 1\n"
            "msg.orientation.w = 1\n"
            "imu = sensor_msgs.msg.CameraInfo()\n"
            "imu.K = imu.k\n"
        ),
        code("\nh = Header()\nh.seq = 1\nt = Time()\nt.secs = t.to_sec()\nt.other = h.stamp.nsecs\n"),
        code("\nmsg = Twist()\nmsg.liner.x = msg.angular.w = 1\nmsg.data = 1\n"),
        together(
            body("msg = Status()\nmsg = g(msg)\nmsg.batery = 1\n"),
            body("msg = None\nmsg = Status()\nmsg.batery = 1\n", "def f():"),
            body("a, msg = Status(), 1\nmsg.batery = 1\n", "def f():"),
            body("a: Status = g()\na.batery = 1\nb: int = Status()\nb.batery = 1\n"),
            body("a = Status()\nb = a.next\nb.texts = ''\nc = b\nc.texts = ''\n"),
            body("for a in b:\n    a.batery = 1\na = Status()\na.batery = 1\n"),
            body("with b as a:\n    a.batery = 1\na = Status()\n"),
            body("a = Status()\na += 1\na.batery = 1\n"),
            body("try:\n    pass\nexcept E as a:\n    pass\na = Status()\na.batery = 1\n"),
            body("global a\na = Status()\na.batery = 1\n"),
            body("a = Status()\n\ndef a():\n    pass\n\na.batery = 1\n"),
            body("a = Status()\nmatch x:\n    case [a, *b]:\n        pass\na.batery = 1\n"),
            body("a = Status()\nprint([a.batery for a in c], a.batery)\n"),
            body("a = Status()\nprint(lambda a: a.batery)\n"),
            body("a = Status()\nif hasattr(a, 'batery'):\n    a.batery = 1\n"),
            body("a = Status()\nif isinstance(a, str):\n    a.batery = 1\n"),
            body("a = Status()\ntry:\n    a.batery = 1\nexcept AttributeError:\n    a.batery = 2\n"),
            body("a = Status()\ntry:\n    a.batery = 1\nexcept (ValueError, Exception):\n    pass\n"),
            body("a = Status()\ntry:\n    a.batery = 1\nexcept ValueError:\n    pass\n"),
            body("a = Status()\ntry:\n    a.batery = 1\nexcept:\n    pass\n"),
            body("a = Status()\nif ROS_VERSION == 1:\n    a.batery = 1\nelif ROS_VERSION == 2:\n    a.battery = 1\n"),
            body("a = Status()\nif ros.ROS_VERSION != 1:\n    a.batery = 1\nelse:\n    a.texts = ''\n"),
            body("a = Status()\nif ros_version() == 3:\n    a.batery = 1\nelif VERSION == 1:\n    a.texts = ''\n"),
            body("a = Status()\nif int(environ['ROS_VERSION']) == 1:\n    a.batery = 1\n"),
            body("a = Status()\nif os.getenv('ROS_VERSION') == '1':\n    a.batery = 1\n"),
            body("msg.batery = 1\n", "def f(self, msg: Status):"),
            body("msg.batery = 1\n", "async def f(self, *, msg: Status):"),
            body("msg.batery = 1\n", "def f(self, msg: int):"),
        ),
        code("\n\ndef f(msg: Status):\n    msg.batery = 1\n\n\nf(String())\n"),
        code("\n\ndef f(Status):\n    a = Status()\n    a.batery = 1\n"),
        code("\nfrom other.msg import Status\n\na = Status()\na.batery = 1\n"),
        code("\ntry:\n    pass\nexcept E as String:\n    pass\na = String()\na.dat = 1\n"),
        code(
            "\n"
            "from std_msgs.msg import String as S\n"
            "import std_msgs.msg as m\n"
            "from std_msgs import msg as n\n"
            "S().dat\n"
            "m.String().dat\n"
            "n.String().dat\n"
        ),
        code(
            "\n"
            "from .msg import Bool\n"
            "import yaml.msg\n"
            "from other.utils import Bool as B\n"
            "Bool().dat\n"
            "yaml.msg.Bool().dat\n"
            "B().dat\n"
        ),
        together(
            node(HEAR, "def hear(self, msg):\n    print(msg.batery, msg.battery)\n"),
            node(HEAR, "def hear(self, msg: String):\n    print(msg.batery, msg.dat)\n"),
            node(HEAR + HEAR, "def hear(self, msg):\n    print(msg.batery)\n"),
            node(HEAR + HEAR.replace("Status", "String"), "def hear(self, msg):\n    print(msg.batery)\n"),
            node(HEAR, "def hear(self, msg):\n    print(msg.batery)\n\ndef g(self):\n    self.hear(self)\n"),
            node(HEAR, "@other\ndef hear(self, msg):\n    print(msg.batery)\n"),
            node(HEAR.replace("10", "10, raw=True"), "def hear(self, msg):\n    print(msg.batery)\n"),
            node(
                HEAR.replace("self.hear, 10", "callback=self.hear, qos_profile=10"),
                "def hear(self, msg):\n    print(msg.batery)\n",
            ),
            node(HEAR.replace("self.hear", "other.hear"), "def hear(self, msg):\n    print(msg.batery)\n"),
            node(HEAR.replace("self.hear, 10", "*args"), "def hear(self, msg):\n    print(msg.batery)\n"),
            node(HEAR.replace("Status,", "SetMode,"), "def hear(self, msg):\n    print(msg.mod)\n"),
            node(HEAR.replace("Status,", "self.kind,"), "def hear(self, msg):\n    print(msg.mod)\n"),
            node(
                SERVE, "def serve(self, request, response):\n    response.sucess = request.mod\n    return response\n"
            ),
            node("self.msg = Status()\n", "def f(self):\n    self.msg.batery = 1\n"),
            node("self.msg = Status()\n", "def f(self):\n    self.msg = g()\n    self.msg.batery = 1\n"),
            node(
                "self.msg = None\n", "def f(self):\n    self.msg = Status()\n\ndef g(self):\n    self.msg.batery = 1\n"
            ),
            node("self.msg: Status = g()\n", "def f(self):\n    self.msg.batery = 1\n"),
            node(
                "self.msg = Status()\n",
                "def f(self):\n    if hasattr(self.msg, 'batery'):\n        self.msg.batery = 1\n",
            ),
            node("self.msg = Status()\n", "msg = None\n\ndef f(self):\n    self.msg.batery = 1\n"),
            node("msg = Status()\nself.msg = msg\n", "def f(self):\n    self.msg.batery = 1\n"),
            node("msg = Status()\n", "def f(self):\n    msg.batery = 1\n"),
        ),
        code("\n\ndef hear(msg):\n    print(msg.batery)\n\n\nnode.create_subscription(Status, 'a', hear, 10)\n"),
        code("\n\ndef f():\n    msg = Status()\n\n    def g():\n        msg.batery = 1\n"),
    ),
}
