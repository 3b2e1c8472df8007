#pragma once

#include <map>
#include <string>

#include "behaviortree_cpp/condition_node.h"

namespace BT
{
class BehaviorTreeFactory
{
public:
  template<typename T>
  void registerNodeType(const std::string & name)
  {
    T made(name, NodeConfiguration());
    made.tick();
    T::providedPorts();
  }
  void registerFromPlugin(const std::string &) {}
  const std::map<std::string, int> & manifests() const {return manifests_;}

private:
  std::map<std::string, int> manifests_;
};
}  // namespace BT

#define BT_REGISTER_NODES(factory) \
  extern "C" void BT_RegisterNodesFromPlugin(BT::BehaviorTreeFactory & factory)
