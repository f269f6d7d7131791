// The stock library of bags: writes one, reads all of it, and goes to places in it. Answers each line with one line of JSON.
#include <chrono>
#include <cmath>
#include <iostream>
#include <sstream>
#include <vector>

#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <sensor_msgs/Image.h>
#include <std_msgs/String.h>

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kGolden = 0.6180339887498949;
constexpr int kSmallOfAnImage = 100;

double since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

// Images of 1 MiB at 100 Hz, and 100 small messages with each.
void write(const std::string& file, int megabytes) {
  rosbag::Bag bag(file, rosbag::bagmode::Write);
  sensor_msgs::Image image;
  image.width = 1024;
  image.height = 1024;
  image.step = 1024;
  image.encoding = "mono8";
  image.data.resize(1 << 20);
  for (std::size_t i = 0; i < image.data.size(); ++i) image.data[i] = static_cast<std::uint8_t>(i * 2654435761U >> 13);
  std_msgs::String small;
  small.data.assign(100, 'x');
  for (int i = 0; i < megabytes; ++i) {
    const ros::Time at(1000 + i * 0.01);
    image.header.stamp = at;
    image.header.seq = static_cast<std::uint32_t>(i);
    bag.write("/image", at, image);
    for (int j = 0; j < kSmallOfAnImage; ++j) bag.write("/small", at + ros::Duration(j * 1e-5), small);
  }
  bag.close();
  std::cout << "{}" << std::endl;
}

void read(const std::string& file) {
  const auto begin = Clock::now();
  rosbag::Bag bag(file, rosbag::bagmode::Read);
  rosbag::View view(bag);
  std::vector<std::uint8_t> bytes;
  std::uint64_t messages = 0, total = 0;
  for (const rosbag::MessageInstance& message : view) {
    bytes.resize(message.size());
    ros::serialization::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
    message.write(stream);
    ++messages;
    total += bytes.size();
  }
  std::cout << "{\"seconds\":" << since(begin) << ",\"messages\":" << messages << ",\"bytes\":" << total << "}" << std::endl;
}

void seek(const std::string& file, int times) {
  const auto begin = Clock::now();
  rosbag::Bag bag(file, rosbag::bagmode::Read);
  double start = 0, length = 0;
  {
    rosbag::View view(bag);
    start = view.getBeginTime().toSec();
    length = view.getEndTime().toSec() - start;
  }
  std::cout << "{\"open\":" << since(begin) << ",\"seeks\":[";
  std::vector<std::uint8_t> bytes;
  for (int i = 0; i < times; ++i) {
    const auto went = Clock::now();
    rosbag::View view(bag, ros::Time(start + length * std::fmod((i + 1) * kGolden, 1)));
    const rosbag::MessageInstance message = *view.begin();
    bytes.resize(message.size());
    ros::serialization::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
    message.write(stream);
    std::cout << (i == 0 ? "" : ",") << since(went);
  }
  std::cout << "]}" << std::endl;
}

}  // namespace

int main() {
  for (std::string line; std::getline(std::cin, line);) {
    std::istringstream words(line);
    std::string verb, file;
    int number = 0;
    words >> verb >> file >> number;
    try {
      if (verb == "write") write(file, number);
      if (verb == "read") read(file);
      if (verb == "seek") seek(file, number);
    } catch (const std::exception& e) {
      std::cout << "error " << e.what() << std::endl;
    }
  }
}
