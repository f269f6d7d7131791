// Publishes at a pace: "BYTES RATE SECONDS" on stdin; on stdout "begins" once somebody listens, and how many messages that were.
#include <chrono>
#include <iostream>
#include <thread>

#include <ros/ros.h>
#include <std_msgs/String.h>

int main(int argc, char** argv) {
  ros::init(argc, argv, "talker");
  ros::NodeHandle node;
  const ros::Publisher publisher = node.advertise<std_msgs::String>("/said", 100'000);
  ros::AsyncSpinner spinner(1);
  spinner.start();
  for (double bytes, rate, seconds; std::cin >> bytes >> rate >> seconds;) {
    while (publisher.getNumSubscribers() == 0) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    std::this_thread::sleep_for(std::chrono::seconds(1));
    std::cout << "begins" << std::endl;
    std_msgs::String message;
    message.data.assign(static_cast<std::size_t>(bytes), 'x');
    const auto begin = std::chrono::steady_clock::now();
    const auto count = static_cast<long>(rate * seconds);
    for (long i = 0; i < count && ros::ok(); ++i) {
      publisher.publish(message);
      std::this_thread::sleep_until(begin + std::chrono::duration_cast<std::chrono::nanoseconds>(
                                                std::chrono::duration<double>(static_cast<double>(i) / rate)));
    }
    std::cout << count << std::endl;
  }
}
