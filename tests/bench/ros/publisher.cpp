// The publisher of all measurements. Reads lines "KIND TOPIC WARM_SECONDS MEASURED_SECONDS" and answers each with the
// number of messages it sent, or with a line that starts with "error".
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <std_msgs/String.h>

#include <iostream>
#include <sstream>

#include "probe.hpp"

namespace {

constexpr int64_t SECOND = 1000000000;
constexpr int64_t PATIENCE = 20 * SECOND;

// No more than `window` messages are on their way, so that a queue of twice that never drops one; a `period` of 0 sends
// as fast as that allows.
struct Pace {
  uint32_t window;
  int64_t period;
  uint32_t queue() const { return 2 * window; }
};

template <typename Condition>
void wait_for(Condition condition, int microseconds, const char* what) {
  for (int64_t end = probe::now() + PATIENCE; !condition(); usleep(microseconds)) {
    if (probe::now() > end) throw std::runtime_error(what);
  }
}

void sleep_until(int64_t time) {
  timespec at{time / SECOND, time % SECOND};
  clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &at, nullptr);
}

std_msgs::String small_message() {
  std_msgs::String message;
  message.data.assign(96, '.');  // 100 bytes with its length
  return message;
}

std::string& text(std_msgs::String& message) { return message.data; }

sensor_msgs::Image image() {
  sensor_msgs::Image message;
  message.header.frame_id.assign(probe::TAG, '.');
  message.height = 1024;
  message.width = message.step = 1024;
  message.encoding = "mono8";
  message.data.assign(1 << 20, 7);
  return message;
}

std::string& text(sensor_msgs::Image& message) { return message.header.frame_id; }

template <typename M>
uint64_t send(const ros::Publisher& publisher, M message, Pace pace, double warm, double measured, const probe::Credit& credit) {
  const int64_t start = probe::now();
  const int64_t measured_from = start + int64_t(warm * SECOND);
  const int64_t end = measured_from + int64_t(measured * SECOND);
  uint64_t number = 0;
  for (int64_t time = start; time < end; number++) {
    wait_for([&] { return number - credit.get() < pace.window; }, 50, "the subscriber does not keep up");
    if (pace.period > 0) sleep_until(start + int64_t(number) * pace.period);
    time = probe::now();
    probe::tag(text(message), time < measured_from ? probe::WARM : probe::MEASURED, number, time);
    publisher.publish(message);
  }
  probe::tag(text(message), probe::END, number, probe::now());
  publisher.publish(message);
  wait_for([&] { return credit.get() == number + 1; }, 200, "the last message did not arrive");
  return number + 1;
}

template <typename M>
uint64_t run(const std::string& topic, M message, Pace pace, double warm, double measured, probe::Credit& credit) {
  credit.set(0);
  ros::NodeHandle node;
  ros::Publisher publisher = node.advertise<M>(topic, pace.queue());
  wait_for([&] { return publisher.getNumSubscribers() == 1; }, 1000, "nobody subscribed");
  return send(publisher, message, pace, warm, measured, credit);
}

uint64_t obey(const std::string& line, probe::Credit& credit) {
  std::istringstream words(line);
  std::string kind, topic;
  double warm, measured;
  if (!(words >> kind >> topic >> warm >> measured)) throw std::runtime_error("what is '" + line + "'?");
  if (kind == "small") return run(topic, small_message(), Pace{5000, 0}, warm, measured, credit);
  if (kind == "latency") return run(topic, small_message(), Pace{5000, SECOND / 1000}, warm, measured, credit);
  if (kind == "image") return run(topic, image(), Pace{8, 0}, warm, measured, credit);
  throw std::runtime_error("there is no kind '" + kind + "'");
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "bench_publisher", ros::init_options::NoRosout);
  probe::Credit credit(argv[1]);
  ros::NodeHandle keeps_running;
  for (std::string line; std::getline(std::cin, line);) {
    try {
      std::cout << obey(line, credit) << std::endl;
    } catch (const std::runtime_error& e) {
      std::cout << "error: " << e.what() << std::endl;
    }
  }
}
