#include "master_watch.h"

#include <chrono>

#include <ros/master.h>
#include <ros/this_node.h>
#include <xmlrpcpp/XmlRpcValue.h>

namespace robotui::rt::ros_bridge {
namespace {

constexpr std::chrono::milliseconds kStep{100};
constexpr int kSteps = 10;

bool isKnown() {
  XmlRpc::XmlRpcValue request, response, payload;
  request[0] = ros::this_node::getName();
  request[1] = ros::this_node::getName();
  return ros::master::execute("lookupNode", request, response, payload, false);
}

}  // namespace

MasterWatch::MasterWatch() : thread_([this] { watch(); }) {}

MasterWatch::~MasterWatch() {
  going_ = false;
  thread_.join();
}

void MasterWatch::watch() {
  while (going_) {
    for (int i = 0; i < kSteps && going_; ++i) std::this_thread::sleep_for(kStep);
    if (going_ && !isKnown() && ros::master::check()) forgotten_ = true;
  }
}

}  // namespace robotui::rt::ros_bridge
