#pragma once
#include "behaviortree_cpp/condition_node.h"
