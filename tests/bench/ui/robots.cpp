// As many robots as asked for, each below a name of its own: a scan at 40 Hz, odometry at 100 Hz, an image of 320x240 at 30 Hz.
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2_msgs/TFMessage.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace {

constexpr int kBeams = 541;
constexpr int kWidth = 320, kHeight = 240;

class Robot {
 public:
  explicit Robot(int number) : node_("r" + std::to_string(number)), phase_(number) {
    scans_ = node_.advertise<sensor_msgs::LaserScan>("scan", 1);
    odometry_ = node_.advertise<nav_msgs::Odometry>("odom", 1);
    images_ = node_.advertise<sensor_msgs::Image>("image", 1);
    transforms_ = node_.advertise<tf2_msgs::TFMessage>("/tf", 10);
    prepare(number);
    timers_.push_back(node_.createTimer(ros::Duration(1.0 / 40), [this](const ros::TimerEvent&) { scan(); }));
    timers_.push_back(node_.createTimer(ros::Duration(1.0 / 100), [this](const ros::TimerEvent&) { move(); }));
    timers_.push_back(node_.createTimer(ros::Duration(1.0 / 30), [this](const ros::TimerEvent&) { see(); }));
  }

 private:
  void prepare(int number) {
    base_ = "base" + std::to_string(number);
    scan_.angle_min = -2.36F;
    scan_.angle_max = 2.36F;
    scan_.angle_increment = 4.72F / (kBeams - 1);
    scan_.range_max = 30;
    scan_.ranges.resize(kBeams);
    scan_.header.frame_id = base_;
    image_.width = kWidth;
    image_.height = kHeight;
    image_.encoding = "rgb8";
    image_.step = kWidth * 3;
    image_.data.resize(static_cast<size_t>(image_.step) * kHeight);
  }

  void scan() {
    scan_.header.stamp = ros::Time::now();
    for (int i = 0; i < kBeams; ++i) {
      scan_.ranges[static_cast<size_t>(i)] = static_cast<float>(4 + std::sin(0.05 * i + phase_));
    }
    scans_.publish(scan_);
  }

  void move() {
    phase_ += 0.01;
    nav_msgs::Odometry odometry;
    odometry.header.stamp = ros::Time::now();
    odometry.header.frame_id = "odom";
    odometry.child_frame_id = base_;
    odometry.pose.pose.position.x = 2 * std::cos(phase_);
    odometry.pose.pose.position.y = 2 * std::sin(phase_);
    odometry.pose.pose.orientation.z = std::sin(phase_ / 2);
    odometry.pose.pose.orientation.w = std::cos(phase_ / 2);
    odometry.twist.twist.linear.x = 0.5;
    odometry_.publish(odometry);
    tf2_msgs::TFMessage transforms;
    geometry_msgs::TransformStamped transform;
    transform.header = odometry.header;
    transform.child_frame_id = base_;
    transform.transform.translation.x = odometry.pose.pose.position.x;
    transform.transform.translation.y = odometry.pose.pose.position.y;
    transform.transform.rotation = odometry.pose.pose.orientation;
    transforms.transforms.push_back(transform);
    transforms_.publish(transforms);
  }

  void see() {
    image_.header.stamp = ros::Time::now();
    ++shade_;
    for (size_t i = 0; i < image_.data.size(); i += 97) {
      image_.data[i] = static_cast<uint8_t>(i + shade_);
    }
    images_.publish(image_);
  }

  ros::NodeHandle node_;
  double phase_;
  unsigned shade_ = 0;
  std::string base_;
  sensor_msgs::LaserScan scan_;
  sensor_msgs::Image image_;
  ros::Publisher scans_, odometry_, images_, transforms_;
  std::vector<ros::Timer> timers_;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::cerr << "usage: robots COUNT" << std::endl;
    return EXIT_FAILURE;
  }
  ros::init(argc, argv, "robots", ros::init_options::NoSigintHandler);
  std::vector<std::unique_ptr<Robot>> robots;
  for (int i = 0; i < std::atoi(argv[1]); ++i) {
    robots.push_back(std::make_unique<Robot>(i));
  }
  std::cout << "ready" << std::endl;
  ros::spin();
}
