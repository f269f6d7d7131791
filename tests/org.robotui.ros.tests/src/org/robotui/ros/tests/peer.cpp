// A roscpp peer with four roles: peer talker|listener|server|caller NODE NAME
#include <iostream>
#include <sstream>
#include <string>

#include <ros/ros.h>
#include <std_msgs/String.h>
#include <std_srvs/SetBool.h>

static void heard(const ros::MessageEvent<std_msgs::String const>& event) {
  std::cout << event.getPublisherName() << " " << event.getMessage()->data << std::endl;
}

static bool serve(ros::ServiceEvent<std_srvs::SetBoolRequest, std_srvs::SetBoolResponse>& event) {
  event.getResponse().success = true;
  event.getResponse().message = "on by " + event.getCallerName();
  return event.getRequest().data;
}

static void talk(ros::NodeHandle& node, const std::string& node_name, const std::string& topic) {
  ros::Publisher publisher = node.advertise<std_msgs::String>(topic, 10);
  ros::WallRate rate(20);
  for (int number = 0; ros::ok(); number++, rate.sleep()) {
    std_msgs::String message;
    std::ostringstream text;
    text << node_name << " " << number;
    message.data = text.str();
    publisher.publish(message);
  }
}

static void call(ros::NodeHandle& node, const std::string& service) {
  ros::service::waitForService(service, 10000);
  ros::ServiceClient client = node.serviceClient<std_srvs::SetBool>(service, true);
  for (bool data : {true, true, false}) {
    std_srvs::SetBool call;
    call.request.data = data;
    bool done = client.call(call);
    std::cout << (done ? "answer " + call.response.message : "refused") << std::endl;
  }
  std::cout << "done" << std::endl;
}

int main(int argc, char** argv) {
  std::string role = argv[1], node_name = argv[2], name = argv[3];
  ros::init(argc, argv, node_name);
  ros::NodeHandle node;
  std::cout << "ready" << std::endl;
  if (role == "talker") {
    talk(node, node_name, name);
  } else if (role == "listener") {
    ros::Subscriber subscriber = node.subscribe(name, 100, heard);
    ros::spin();
  } else if (role == "server") {
    ros::ServiceServer server = node.advertiseService<std_srvs::SetBoolRequest, std_srvs::SetBoolResponse>(name, serve);
    ros::spin();
  } else {
    call(node, name);
  }
}
