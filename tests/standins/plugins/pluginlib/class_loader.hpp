#pragma once

#include <memory>
#include <string>
#include <utility>

namespace pluginlib
{
template<class T>
class ClassLoader
{
public:
  ClassLoader(std::string, std::string) {}
  std::shared_ptr<T> createSharedInstance(const std::string &) {return nullptr;}
};
}  // namespace pluginlib
