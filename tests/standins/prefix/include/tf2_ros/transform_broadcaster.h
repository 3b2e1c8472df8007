// A stand-in for tf2_ros: signatures of geometry2 (humble d0dbd516, jazzy 646342c6, rolling 1b005c65).

#ifndef TF2_ROS__TRANSFORM_BROADCASTER_H_
#define TF2_ROS__TRANSFORM_BROADCASTER_H_

#include "geometry_msgs/msg/transform_stamped.hpp"

namespace tf2_ros
{
class TransformBroadcaster
{
public:
  template<class NodeT>
  explicit TransformBroadcaster(NodeT && node) {node.get_node_base_interface();}
  void sendTransform(const geometry_msgs::msg::TransformStamped &) {}
};
}  // namespace tf2_ros

#endif  // TF2_ROS__TRANSFORM_BROADCASTER_H_
