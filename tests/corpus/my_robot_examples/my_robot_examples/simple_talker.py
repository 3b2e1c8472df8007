#!/usr/bin/env python3
"""
Simple talker node that publishes messages to a topic
This demonstrates basic publisher functionality in a package
"""
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class SimpleTalker(Node):
    """Simple publisher node that sends messages."""

    def __init__(self):
        super().__init__('simple_talker')
        # Create publisher
        self.publisher_ = self.create_publisher(String, 'chatter', 10)
        # Create timer to send messages periodically
        timer_period = 0.5  # seconds
        self.timer = self.create_timer(timer_period, self.timer_callback)
        # Counter for messages
        self.i = 0
        self.get_logger().info('Simple talker node initialized')

    def timer_callback(self):
        """Callback function that publishes messages."""
        msg = String()
        msg.data = f'Hello World: {self.i}'
        self.publisher_.publish(msg)
        self.get_logger().info(f'Publishing: "{msg.data}"')
        self.i += 1


def main(args=None):
    """Main function for the simple talker node."""
    rclpy.init(args=args)
    simple_talker = SimpleTalker()
    try:
        rclpy.spin(simple_talker)
    except KeyboardInterrupt:
        pass
    finally:
        simple_talker.destroy_node()
        rclpy.shutdown()


if __name__ == '__main__':
    main()
