#pragma once

#include <memory>
#include <string>

#include "geometry_msgs/msg/twist_stamped.hpp"
#include "nav2_core/goal_checker.hpp"
#include "nav2_costmap_2d/costmap_2d_ros.hpp"
#include "nav2_ros_common/lifecycle_node.hpp"
#include "nav2_ros_common/tf2_factories.hpp"
#include "nav_msgs/msg/path.hpp"

namespace nav2_core
{
class Controller
{
public:
  virtual ~Controller() = default;
  virtual void cleanup() = 0;
  virtual void activate() = 0;
  virtual void deactivate() = 0;
  virtual void setSpeedLimit(const double &, const bool &) = 0;
#if defined(HUMBLE) || defined(JAZZY) || defined(KILTED)
  virtual void configure(
    const rclcpp_lifecycle::LifecycleNode::WeakPtr &, std::string,
    std::shared_ptr<tf2_ros::Buffer>, std::shared_ptr<nav2_costmap_2d::Costmap2DROS>) = 0;
  virtual void setPlan(const nav_msgs::msg::Path &) = 0;
  virtual geometry_msgs::msg::TwistStamped computeVelocityCommands(
    const geometry_msgs::msg::PoseStamped &, const geometry_msgs::msg::Twist &, GoalChecker *) = 0;
#else
  virtual void configure(
    const nav2::LifecycleNode::WeakPtr &, std::string,
    nav2::TransformBuffer::SharedPtr, std::shared_ptr<nav2_costmap_2d::Costmap2DROS>) = 0;
  virtual void newPathReceived(const nav_msgs::msg::Path &) = 0;
  virtual geometry_msgs::msg::TwistStamped computeVelocityCommands(
    const geometry_msgs::msg::PoseStamped &, const geometry_msgs::msg::Twist &, GoalChecker *,
    const nav_msgs::msg::Path &, const geometry_msgs::msg::PoseStamped &) = 0;
#endif
};
}  // namespace nav2_core
