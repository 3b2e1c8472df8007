#pragma once

#include <memory>
#include <string>

namespace tf2
{
struct Duration {};
inline Duration durationFromSec(double) {return {};}
}  // namespace tf2

namespace tf2_ros
{
class Buffer
{
public:
  using SharedPtr = std::shared_ptr<Buffer>;
  template<typename T>
  T & transform(const T &, T & out, const std::string &, tf2::Duration = {}) const {return out;}
};
}  // namespace tf2_ros
