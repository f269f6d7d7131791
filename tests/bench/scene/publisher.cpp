// What the scenes show. Reads lines, and answers each with "ready", or with a line that starts with "error":
//   cloud POINTS HZ               sensor_msgs/PointCloud2 on /cloud, of 16 bytes a point
//   markers COUNT HZ              visualization_msgs/MarkerArray on /markers, every cube a marker of its own
//   joints HZ TOPIC... = NAME...  sensor_msgs/JointState of these joints on each topic
// All are latched; 0 Hz sends once. A new line of a kind replaces the one before.
#include <ros/ros.h>
#include <sensor_msgs/JointState.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2_msgs/TFMessage.h>
#include <visualization_msgs/MarkerArray.h>

#include <cmath>
#include <cstring>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace {

constexpr double kTurn = 2 * M_PI;
constexpr double kRadius = 10;                       // metres, of the floor that clouds and markers cover
const double kGolden = M_PI * (3 - std::sqrt(5.0));  // radians

struct Point {
  float x, y, z;
  uint32_t rgb;
};

// A round, wavy floor, evenly covered from the middle outwards. Sectors alternate in colour, so that a turn of the camera is seen
// in every pixel; the last tenth of the message is the white rim, by which one sees that all of it came.
Point point(uint32_t number, uint32_t count) {
  constexpr int kSectors = 14;
  const double share = (number + 0.5) / count;
  const double radius = kRadius * std::sqrt(share);
  const double angle = std::fmod(number * kGolden, kTurn);
  const bool warm = static_cast<int>(angle / kTurn * kSectors) % 2 == 0;
  const uint32_t shade = 200 + (number * 2654435761U >> 27);  // 200 to 231, so that neighbours differ
  const uint32_t color = share > 0.9 ? 0xffffff : warm ? shade << 16 | 0x4020 : 0x2050 << 8 | shade;
  return {static_cast<float>(radius * std::cos(angle)), static_cast<float>(radius * std::sin(angle)),
          static_cast<float>(0.3 * std::sin(radius) * std::cos(3 * angle)), color};
}

sensor_msgs::PointField field(const char* name, uint32_t offset) {
  sensor_msgs::PointField made;
  made.name = name;
  made.offset = offset;
  made.datatype = sensor_msgs::PointField::FLOAT32;
  made.count = 1;
  return made;
}

sensor_msgs::PointCloud2 cloud(uint32_t count) {
  sensor_msgs::PointCloud2 made;
  made.header.frame_id = "map";
  made.height = 1;
  made.width = count;
  made.fields = {field("x", 0), field("y", 4), field("z", 8), field("rgb", 12)};
  made.point_step = sizeof(Point);
  made.row_step = count * made.point_step;
  made.is_dense = 1;
  made.data.resize(made.row_step);
  for (uint32_t i = 0; i < count; ++i) {
    const Point each = point(i, count);
    std::memcpy(&made.data[size_t{i} * sizeof(Point)], &each, sizeof(Point));
  }
  return made;
}

visualization_msgs::MarkerArray markers(uint32_t count) {
  const auto side = static_cast<uint32_t>(std::ceil(std::sqrt(count)));
  const double step = kRadius * std::sqrt(2.0) / side;
  visualization_msgs::MarkerArray made;
  for (uint32_t i = 0; i < count; ++i) {
    visualization_msgs::Marker marker;
    marker.header.frame_id = "map";
    marker.ns = "cubes";
    marker.id = static_cast<int32_t>(i);
    marker.type = visualization_msgs::Marker::CUBE;
    marker.pose.position.x = (i % side + 0.5) * step - kRadius / std::sqrt(2.0);
    marker.pose.position.y = (i / side + 0.5) * step - kRadius / std::sqrt(2.0);
    marker.pose.orientation.w = 1;
    marker.scale.x = marker.scale.y = marker.scale.z = step * 0.6;
    marker.color.r = static_cast<float>(i % side) / side;
    marker.color.g = 0.6F;
    marker.color.b = static_cast<float>(i / side) / side;
    marker.color.a = 1;
    made.markers.push_back(marker);
  }
  return made;
}

// Makes a message new before it is sent again.
void renew(sensor_msgs::PointCloud2& message, unsigned) { message.header.stamp = ros::Time::now(); }

void renew(visualization_msgs::MarkerArray& message, unsigned turn) {
  for (auto& marker : message.markers) {
    marker.header.stamp = ros::Time::now();
    marker.pose.position.z = 0.3 * std::sin(0.02 * marker.id + turn);
  }
}

void renew(sensor_msgs::JointState& message, unsigned) {
  message.header.stamp = ros::Time::now();
  for (size_t i = 0; i < message.position.size(); ++i) {
    message.position[i] = 0.15 * std::sin(2 * message.header.stamp.toSec() + static_cast<double>(i));
  }
}

// The frame of all, and one in it: views know the frames of which transforms speak.
tf2_msgs::TFMessage frames() {
  geometry_msgs::TransformStamped transform;
  transform.header.frame_id = "map";
  transform.header.stamp = ros::Time::now();
  transform.child_frame_id = "floor";
  transform.transform.rotation.w = 1;
  tf2_msgs::TFMessage made;
  made.transforms.push_back(transform);
  return made;
}

class Feeds {
 public:
  Feeds() : frames_(node_.advertise<tf2_msgs::TFMessage>("/tf_static", 1, true)) { frames_.publish(frames()); }

  void obey(const std::string& line) {
    std::istringstream words(line);
    std::string kind;
    uint32_t count = 0;
    double rate = 0;
    if (words >> kind && kind == "joints" && words >> rate) {
      joints(words, rate);
    } else if (words >> count >> rate && kind == "cloud") {
      feed(kind, {"/cloud"}, rate, [count] { return cloud(count); }, count);
    } else if (words && kind == "markers") {
      feed(kind, {"/markers"}, rate, [count] { return markers(count); }, count);
    } else {
      throw std::runtime_error("what is '" + line + "'?");
    }
  }

 private:
  struct Feed {
    std::vector<ros::Publisher> publishers;
    std::shared_ptr<void> message;
    uint32_t count = 0;
    ros::Timer timer;
  };

  void joints(std::istream& words, double rate) {
    std::vector<std::string> topics;
    sensor_msgs::JointState state;
    for (std::string word; words >> word && word != "=";) topics.push_back(word);
    for (std::string word; words >> word;) state.name.push_back(word);
    state.position.resize(state.name.size());
    feed("joints", topics, rate, [state] { return state; }, static_cast<uint32_t>(state.name.size()));
  }

  // Messages are made once: a new rate of the same ones does not send them to a new topic.
  template <typename Make>
  void feed(const std::string& kind, const std::vector<std::string>& topics, double rate, Make make, uint32_t count) {
    using Message = decltype(make());
    Feed& feed = feeds_[kind];
    feed.timer.stop();
    if (feed.publishers.empty()) {
      for (const auto& topic : topics) feed.publishers.push_back(node_.advertise<Message>(topic, 1, true));
    }
    if (!feed.message || feed.count != count) feed.message = std::make_shared<Message>(make());
    feed.count = count;
    auto send = [&feed, turn = 0U]() mutable {
      auto& message = *static_cast<Message*>(feed.message.get());
      renew(message, turn++);
      for (const auto& publisher : feed.publishers) publisher.publish(message);
    };
    send();
    if (rate > 0) feed.timer = node_.createTimer(ros::Duration(1 / rate), [send](const ros::TimerEvent&) mutable { send(); });
  }

  ros::NodeHandle node_;
  ros::Publisher frames_;
  std::map<std::string, Feed> feeds_;
};

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "scene_publisher", ros::init_options::NoRosout | ros::init_options::NoSigintHandler);
  Feeds feeds;
  ros::AsyncSpinner spinner(1);
  spinner.start();
  for (std::string line; std::getline(std::cin, line);) {
    try {
      feeds.obey(line);
      std::cout << "ready" << std::endl;
    } catch (const std::exception& e) {
      std::cout << "error: " << e.what() << std::endl;
    }
  }
}
