#!/usr/bin/env python3
"""
Simple listener node that subscribes to messages
This demonstrates basic subscriber functionality in a package
"""
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class SimpleListener(Node):
    """Simple subscriber node that receives messages."""

    def __init__(self):
        super().__init__('simple_listener')
        # Create subscriber
        self.subscription = self.create_subscription(
            String,
            'chatter',
            self.listener_callback,
            10)
        self.subscription  # prevent unused variable warning
        self.get_logger().info('Simple listener node initialized')

    def listener_callback(self, msg):
        """Callback function that receives messages."""
        self.get_logger().info(f'I heard: "{msg.data}"')


def main(args=None):
    """Main function for the simple listener node."""
    rclpy.init(args=args)
    simple_listener = SimpleListener()
    try:
        rclpy.spin(simple_listener)
    except KeyboardInterrupt:
        pass
    finally:
        simple_listener.destroy_node()
        rclpy.shutdown()


if __name__ == '__main__':
    main()
