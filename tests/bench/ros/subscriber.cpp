// The roscpp subscriber. Reads lines "KIND TOPIC" and answers each with what it saw, as one JSON object.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <std_msgs/String.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstdio>
#include <future>
#include <iostream>
#include <sstream>
#include <vector>

#include "probe.hpp"

namespace {

double cpu_seconds() {
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_utime.tv_sec + usage.ru_stime.tv_sec + (usage.ru_utime.tv_usec + usage.ru_stime.tv_usec) / 1e6;
}

// What came in while it was measured: from the first message of that phase to the one that ends it.
class Tally {
 public:
  explicit Tally(probe::Credit& credit) : credit_(credit) { latencies_.reserve(1 << 20); }

  void add(const std::string& tag) {
    const int64_t time = probe::now();
    const uint64_t number = probe::read_hex(&tag[1]);
    if (tag[0] == probe::MEASURED) {
      if (count_++ == 0) begin(number, time);
      if (latencies_.size() < latencies_.capacity()) latencies_.push_back(time - int64_t(probe::read_hex(&tag[17])));
    } else if (tag[0] == probe::END) {
      finish(number, time);
    }
    credit_.set(number + 1);
    if (tag[0] == probe::END) done_.set_value();
  }

  void await() { done_.get_future().wait(); }

  void print() {
    std::sort(latencies_.begin(), latencies_.end());
    std::printf("{\"count\": %lu, \"lost\": %ld, \"seconds\": %.9f, \"cpu\": %.6f, \"p50\": %ld, \"p99\": %ld}\n", count_,
                long(expected_ - count_), seconds_, cpu_, quantile(0.5), quantile(0.99));
    std::fflush(stdout);
  }

 private:
  void begin(uint64_t number, int64_t time) {
    first_ = number;
    start_ = time;
    cpu_ = -cpu_seconds();
  }

  void finish(uint64_t number, int64_t time) {
    seconds_ = (time - start_) / 1e9;
    cpu_ += cpu_seconds();
    expected_ = number - first_;
  }

  int64_t quantile(double q) const { return latencies_.empty() ? 0 : latencies_[size_t(q * (latencies_.size() - 1))]; }

  probe::Credit& credit_;
  std::vector<int64_t> latencies_;
  std::promise<void> done_;
  uint64_t count_ = 0, first_ = 0, expected_ = 0;
  int64_t start_ = 0;
  double seconds_ = 0, cpu_ = 0;
};

const std::string& tag(const std_msgs::String& message) { return message.data; }
const std::string& tag(const sensor_msgs::Image& message) { return message.header.frame_id; }

template <typename M>
void measure(ros::NodeHandle& node, const std::string& topic, uint32_t queue, probe::Credit& credit) {
  Tally tally(credit);
  boost::function<void(const boost::shared_ptr<const M>&)> callback = [&](const boost::shared_ptr<const M>& message) {
    tally.add(tag(*message));
  };
  ros::Subscriber subscriber = node.subscribe<M>(topic, queue, callback, ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay());
  tally.await();
  subscriber.shutdown();
  tally.print();
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "bench_roscpp", ros::init_options::NoRosout);
  probe::Credit credit(argv[1]);
  ros::NodeHandle node;
  ros::AsyncSpinner spinner(1);
  spinner.start();
  std::string kind, topic;
  for (std::string line; std::getline(std::cin, line);) {
    std::istringstream(line) >> kind >> topic;
    if (kind == "image") {
      measure<sensor_msgs::Image>(node, topic, 16, credit);
    } else {
      measure<std_msgs::String>(node, topic, 10000, credit);
    }
  }
}
