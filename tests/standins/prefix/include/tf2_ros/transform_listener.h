// A stand-in for tf2_ros: signatures of geometry2 (humble d0dbd516, jazzy 646342c6, rolling 1b005c65).

#ifndef TF2_ROS__TRANSFORM_LISTENER_H_
#define TF2_ROS__TRANSFORM_LISTENER_H_

#include "tf2_ros/buffer.h"

namespace tf2_ros
{
class TransformListener
{
public:
  explicit TransformListener(tf2::BufferCore &) {}
};
}  // namespace tf2_ros

#endif  // TF2_ROS__TRANSFORM_LISTENER_H_
