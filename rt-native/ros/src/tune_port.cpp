// Parameters of a plugin as a server of dynamic_reconfigure: /xbotcore/PLUGIN/set_parameters and the two topics.
#include <dynamic_reconfigure/Reconfigure.h>
#include <ros/ros.h>

#include "pending_calls.h"
#include "ports.h"
#include "tuning.h"

namespace robotui::rt::ros_bridge {
namespace {

constexpr std::chrono::milliseconds kPatience{2000};

class TunePort final : public Port {
 public:
  TunePort(const ros::Announcement& port, const PortPlace& place)
      : entries_(port.tunables), generation_(port.generation), reader_(place.channels, place.outName(), port.large),
        writer_(place.channels, place.inName(), port.large), node_(place.topic("")) {
    if (entries_.size() * sizeof(double) > writer_.room()) throw std::runtime_error("it has too many parameters");
    for (const auto& entry : entries_) values_.push_back(entry.initial);
    node_.setCallbackQueue(&place.queue);
    descriptions_ = node_.advertise<dynamic_reconfigure::ConfigDescription>("parameter_descriptions", 1, true);
    descriptions_.publish(descriptionOf(entries_));
    updates_ = node_.advertise<dynamic_reconfigure::Config>("parameter_updates", 1, true);
    updates_.publish(configOf(entries_, values_));
    server_ = node_.advertiseService("set_parameters", &TunePort::set, this);
  }

  // What the plugin says that it has now, also after this process was started anew.
  void turn() override {
    while (reader_.next()) {
      if (reader_.bytes().size() != values_.size() * sizeof(double)) continue;
      {
        const std::scoped_lock lock(mutex_);
        std::memcpy(values_.data(), reader_.bytes().data(), reader_.bytes().size());
        updates_.publish(configOf(entries_, values_));
      }
      answers_.settle(reader_.number(), {true, {}});
    }
  }

 private:
  // The answer is what holds, whether the plugin took it or not.
  bool set(dynamic_reconfigure::Reconfigure::Request& request, dynamic_reconfigure::Reconfigure::Response& response) {
    const std::uint32_t number = answers_.expect();
    {
      const std::scoped_lock lock(mutex_);
      std::vector<double> wanted = values_;
      merge(request.config, entries_, wanted);
      const auto* at = reinterpret_cast<const std::uint8_t*>(wanted.data());
      writer_.write({at, wanted.size() * sizeof(double)}, number, generation_);
    }
    const bool taken = answers_.await(number, kPatience).has_value();
    const std::scoped_lock lock(mutex_);
    response.config = configOf(entries_, values_);
    return taken;
  }

  std::vector<ros::TunableEntry> entries_;
  std::uint64_t generation_;
  std::mutex mutex_;
  std::vector<double> values_;
  PendingCalls answers_;
  ros::PacketReader reader_;
  ros::PacketWriter writer_;
  ::ros::NodeHandle node_;
  ::ros::Publisher descriptions_;
  ::ros::Publisher updates_;
  ::ros::ServiceServer server_;  // last: its callbacks use the others
};

}  // namespace

std::unique_ptr<Port> makeTunePort(const ros::Announcement& port, const PortPlace& place) {
  return std::make_unique<TunePort>(port, place);
}

}  // namespace robotui::rt::ros_bridge
