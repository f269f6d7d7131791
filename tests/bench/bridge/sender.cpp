// The sender of all measurements. Each line "KIND TOPIC RATE SECONDS" is answered with the number of messages that it sent. With a RATE it sends so many in
// a second; with 0 it has no more on their way than a window, and gives those up that do not come. "KIND TOPIC touch" sends until one has arrived.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <std_msgs/String.h>

#include <iostream>
#include <map>
#include <sstream>

#include "../ros/probe.hpp"

namespace {

constexpr int64_t SECOND = 1000000000;
constexpr int64_t GIVEN_UP = SECOND / 2;
constexpr uint32_t QUEUE = 1000;

class Sender {
 public:
  Sender(ros::NodeHandle& node, const std::string& topic, bool image) : image_(image) {
    if (image) {
      picture_.header.frame_id.assign(probe::TAG, '.');
      picture_.height = picture_.width = picture_.step = 1024;
      picture_.encoding = "mono8";
      picture_.data.assign(1 << 20, 7);
      publisher_ = node.advertise<sensor_msgs::Image>(topic, QUEUE);
    } else {
      text_.data.assign(96, '.');  // 100 bytes with its length
      publisher_ = node.advertise<std_msgs::String>(topic, QUEUE);
    }
  }

  uint64_t touch(probe::Credit& credit) {
    credit.set(0);
    for (int64_t end = probe::now() + 30 * SECOND; credit.get() == 0; usleep(50000)) {
      if (probe::now() > end) throw std::runtime_error("nothing arrives");
      send(0);
    }
    return 1;
  }

  uint64_t run(double rate, double seconds, probe::Credit& credit) {
    const int64_t start = probe::now(), end = start + int64_t(seconds * SECOND);
    const uint64_t window = image_ ? 4 : 32;
    credit.set(0);
    uint64_t number = 0, given_up = 0;
    for (int64_t time = start; time < end; time = probe::now()) {
      if (rate > 0) sleep_until(start + int64_t(number * (SECOND / rate)));
      for (int64_t patience = time + GIVEN_UP; rate == 0 && number - given_up >= credit.get() + window; usleep(20)) {
        if (probe::now() > patience) given_up = number - credit.get();
      }
      send(number++);
    }
    return number;
  }

 private:
  void send(uint64_t number) {
    if (image_) {
      probe::tag(picture_.header.frame_id, probe::MEASURED, number, probe::now());
      publisher_.publish(picture_);
    } else {
      probe::tag(text_.data, probe::MEASURED, number, probe::now());
      publisher_.publish(text_);
    }
  }

  static void sleep_until(int64_t time) {
    timespec at{time / SECOND, time % SECOND};
    clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &at, nullptr);
  }

  bool image_;
  sensor_msgs::Image picture_;
  std_msgs::String text_;
  ros::Publisher publisher_;
};

uint64_t obey(const std::string& line, ros::NodeHandle& node, std::map<std::string, Sender>& senders, probe::Credit& credit) {
  std::istringstream words(line);
  std::string kind, topic, rate;
  double seconds = 0;
  words >> kind >> topic >> rate >> seconds;
  Sender& sender = senders.try_emplace(topic, node, topic, kind == "image").first->second;
  return rate == "touch" ? sender.touch(credit) : sender.run(std::stod(rate), seconds, credit);
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "bench_sender", ros::init_options::NoRosout);
  probe::Credit credit(argv[1]);
  ros::NodeHandle node;
  std::map<std::string, Sender> senders;
  for (std::string line; std::getline(std::cin, line);) {
    try {
      std::cout << obey(line, node, senders, credit) << std::endl;
    } catch (const std::exception& e) {
      std::cout << "error: " << e.what() << std::endl;
    }
  }
}
