import rclpy
from geometry_msgs.msg import PoseStamped
from my_robot_nav.msg import RobotPath
from rclpy.node import Node


class NavNode(Node):

    def __init__(self):
        super().__init__('nav_node')
        self.create_subscription(PoseStamped, 'goal_pose', self.on_goal, 10)
        self.publisher = self.create_publisher(RobotPath, 'path', 10)

    def on_goal(self, msg):
        self.publisher.publish(RobotPath(poses=[msg]))


def main(args=None):
    rclpy.init(args=args)
    rclpy.spin(NavNode())
