#pragma once

#include <atomic>
#include <string>

#include "nav2_costmap_2d/costmap_2d.hpp"
#include "nav2_ros_common/lifecycle_node.hpp"

namespace nav2_costmap_2d
{
class Layer
{
public:
  virtual ~Layer() = default;
  virtual void deactivate() {}
  virtual void activate() {}
  virtual void reset() = 0;
  virtual bool isClearable() = 0;
  virtual void updateBounds(double, double, double, double *, double *, double *, double *) = 0;
  virtual void updateCosts(Costmap2D &, int, int, int, int) = 0;
  std::string getFullName(const std::string & name) {return name;}

protected:
  virtual void onInitialize() {}
#if defined(HUMBLE) || defined(JAZZY) || defined(KILTED)
  rclcpp_lifecycle::LifecycleNode::WeakPtr node_;
  bool current_ = false;
#else
  nav2::LifecycleNode::WeakPtr node_;
  std::atomic_bool current_;
#endif
  bool enabled_ = false;
};
}  // namespace nav2_costmap_2d
