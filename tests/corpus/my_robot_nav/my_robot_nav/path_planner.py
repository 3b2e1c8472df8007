import numpy as np
import rclpy
from nav_msgs.msg import OccupancyGrid
from rclpy.node import Node
from tf2_ros import Buffer, TransformListener


class PathPlanner(Node):

    def __init__(self):
        super().__init__('path_planner')
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)
        self.create_subscription(OccupancyGrid, 'map', self.on_map, 10)

    def on_map(self, msg):
        self.grid = np.array(msg.data).reshape(msg.info.height, msg.info.width)


def main(args=None):
    rclpy.init(args=args)
    rclpy.spin(PathPlanner())
