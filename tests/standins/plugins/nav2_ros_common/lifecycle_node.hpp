#pragma once

#include <memory>

#include "rclcpp_lifecycle/lifecycle_node.hpp"

namespace nav2
{
class LifecycleNode : public rclcpp_lifecycle::LifecycleNode
{
public:
  using WeakPtr = std::weak_ptr<nav2::LifecycleNode>;
};
}  // namespace nav2
