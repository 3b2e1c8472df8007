#!/usr/bin/env python3
"""
Sensor processing node that demonstrates message filtering
This shows more complex processing within a package
"""
import rclpy
from rclpy.node import Node
from sensor_msgs.msg import LaserScan
from std_msgs.msg import Float32


class SensorProcessor(Node):
    """Node that processes sensor data and publishes processed results."""

    def __init__(self):
        super().__init__('sensor_processor')
        # Create subscriber for laser scan data
        self.subscription = self.create_subscription(
            LaserScan,
            'scan',
            self.scan_callback,
            10)
        # Create publisher for processed data
        self.publisher = self.create_publisher(Float32, 'min_distance', 10)
        # Parameters
        self.declare_parameter('distance_threshold', 1.0)
        self.threshold = self.get_parameter('distance_threshold').value
        self.get_logger().info('Sensor processor node initialized')

    def scan_callback(self, msg):
        """Process laser scan data and publish minimum distance."""
        if len(msg.ranges) > 0:
            # Find minimum distance in scan
            min_distance = min([r for r in msg.ranges if r > 0 and r < float('inf')], default=float('inf'))
            # Publish minimum distance if below threshold (potential obstacle)
            if min_distance < self.threshold:
                distance_msg = Float32()
                distance_msg.data = min_distance
                self.publisher.publish(distance_msg)
                self.get_logger().warn(f'Obstacle detected at {min_distance:.2f}m!')


def main(args=None):
    """Main function for the sensor processor node."""
    rclpy.init(args=args)
    sensor_processor = SensorProcessor()
    try:
        rclpy.spin(sensor_processor)
    except KeyboardInterrupt:
        pass
    finally:
        sensor_processor.destroy_node()
        rclpy.shutdown()


if __name__ == '__main__':
    main()
