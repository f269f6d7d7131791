// A small world that speaks the real transport of Gazebo: a base that obeys velocities, a box, a laser, a camera, joints
// and a clock. It prints what it is told, a line each. gazebo_world [--joints N]
#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <mutex>
#include <string>
#include <thread>

#include <ignition/msgs.hh>
#include <ignition/transport.hh>

namespace
{
namespace msgs = ignition::msgs;

std::atomic<bool> over{false};

void End(int)
{
  over = true;
}

/// What the world is like now; guarded by its own mutex.
struct World
{
  std::mutex mutex;
  double x{0}, yaw{0}, forward{0}, turn{0};
  std::int64_t step{0};
  bool paused{false};
  std::int64_t allowed{0};
};

constexpr int kStepsASecond = 50;

void Say(const std::string &line)
{
  std::cout << line << std::endl;
}

void Stamp(msgs::Header *header, std::int64_t step, const std::string &frame, const std::string &child = "")
{
  header->mutable_stamp()->set_sec(step / kStepsASecond);
  header->mutable_stamp()->set_nsec(static_cast<std::int32_t>(step % kStepsASecond * (1000000000 / kStepsASecond)));
  for (const auto &[key, value] : {std::pair<std::string, std::string>{"frame_id", frame}, {"child_frame_id", child}})
  {
    if (!value.empty())
    {
      auto data = header->add_data();
      data->set_key(key);
      data->add_value(value);
    }
  }
}

void Place(msgs::Pose *pose, double x, double y, double z, double yaw)
{
  pose->mutable_position()->set_x(x);
  pose->mutable_position()->set_y(y);
  pose->mutable_position()->set_z(z);
  pose->mutable_orientation()->set_z(std::sin(yaw / 2));
  pose->mutable_orientation()->set_w(std::cos(yaw / 2));
}

void Box(msgs::Link *link, const std::string &name, unsigned id, double x, double y, double z)
{
  auto visual = link->add_visual();
  visual->set_name(name);
  visual->set_id(id);
  visual->mutable_geometry()->set_type(msgs::Geometry::BOX);
  auto size = visual->mutable_geometry()->mutable_box()->mutable_size();
  size->set_x(x);
  size->set_y(y);
  size->set_z(z);
}

bool Scene(msgs::Scene &scene)
{
  scene.set_name("yard");
  auto base = scene.add_model();
  base->set_name("rover");
  base->set_id(4);
  auto chassis = base->add_link();
  chassis->set_name("chassis");
  chassis->set_id(5);
  Box(chassis, "body", 6, 0.5, 0.4, 0.2);
  auto laser = chassis->add_sensor();
  laser->set_name("laser");
  laser->set_id(7);
  Place(laser->mutable_pose(), 0.2, 0, 0.1, 0);
  auto crate = scene.add_model();
  crate->set_name("crate");
  crate->set_id(8);
  crate->set_is_static(true);
  Place(crate->mutable_pose(), 3, 0, 0.5, 0);
  auto wood = crate->add_link();
  wood->set_name("wood");
  wood->set_id(9);
  Box(wood, "planks", 10, 1, 1, 1);
  return true;
}

/// Publishes all that the world says, once a step.
class Voice
{
  public: Voice(ignition::transport::Node &node, int joints) : joints(joints)
  {
    this->clock = node.Advertise<msgs::Clock>("/clock");
    this->stats = node.Advertise<msgs::WorldStatistics>("/world/yard/stats");
    this->poses = node.Advertise<msgs::Pose_V>("/world/yard/pose/info");
    this->odometry = node.Advertise<msgs::Odometry>("/model/rover/odometry");
    this->scan = node.Advertise<msgs::LaserScan>("/scan");
    this->image = node.Advertise<msgs::Image>("/camera");
    this->model = node.Advertise<msgs::Model>("/world/yard/model/rover/joint_state");
    this->odd = node.Advertise<msgs::Wind>("/odd");
    this->contacts = node.Advertise<msgs::Contacts>("/world/yard/model/crate/link/wood/sensor/bumper/contact");
  }

  public: void Speak(const World &world)
  {
    msgs::Clock time;
    time.mutable_sim()->set_sec(world.step / kStepsASecond);
    time.mutable_sim()->set_nsec(static_cast<std::int32_t>(world.step % kStepsASecond * (1000000000 / kStepsASecond)));
    this->clock.Publish(time);
    msgs::Pose_V all;
    Stamp(all.mutable_header(), world.step, "");
    auto rover = all.add_pose();
    rover->set_name("rover");
    rover->set_id(4);
    Place(rover, world.x, 0, 0, world.yaw);
    auto chassis = all.add_pose();
    chassis->set_name("chassis");
    chassis->set_id(5);
    Place(chassis, 0, 0, 0.1, 0);
    this->poses.Publish(all);
    if (world.step % 5 == 0)
    {
      this->Slow(world);
    }
  }

  private: void Slow(const World &world)
  {
    msgs::WorldStatistics said;
    said.mutable_sim_time()->set_sec(world.step / kStepsASecond);
    said.set_paused(world.paused);
    said.set_iterations(static_cast<std::uint64_t>(world.step));
    said.set_real_time_factor(1);
    this->stats.Publish(said);

    msgs::Odometry moved;
    Stamp(moved.mutable_header(), world.step, "rover/odom", "rover/chassis");
    Place(moved.mutable_pose(), world.x, 0, 0, world.yaw);
    moved.mutable_twist()->mutable_linear()->set_x(world.forward);
    moved.mutable_twist()->mutable_angular()->set_z(world.turn);
    this->odometry.Publish(moved);

    msgs::LaserScan seen;
    Stamp(seen.mutable_header(), world.step, "rover::chassis::laser");
    seen.set_frame("rover::chassis::laser");
    seen.set_angle_min(-1);
    seen.set_angle_max(1);
    seen.set_angle_step(0.1);
    seen.set_range_min(0.1);
    seen.set_range_max(10);
    seen.set_count(21);
    for (int i = 0; i < 21; ++i)
    {
      seen.add_ranges(2.3);
      seen.add_intensities(0);
    }
    this->scan.Publish(seen);

    msgs::Image picture;
    Stamp(picture.mutable_header(), world.step, "rover::chassis::camera");
    picture.set_width(32);
    picture.set_height(24);
    picture.set_step(96);
    picture.set_pixel_format_type(msgs::RGB_INT8);
    picture.set_data(std::string(96 * 24, static_cast<char>(world.step)));
    this->image.Publish(picture);

    msgs::Model state;
    Stamp(state.mutable_header(), world.step, "");
    state.set_name("rover");
    for (int i = 0; i < this->joints; ++i)
    {
      auto joint = state.add_joint();
      joint->set_name("joint" + std::to_string(i));
      joint->mutable_axis1()->set_position(0.1 * i);
    }
    this->model.Publish(state);

    msgs::Contacts touched;
    Stamp(touched.mutable_header(), world.step, "");
    auto contact = touched.add_contact();
    contact->mutable_collision1()->set_name("crate::wood::collision");
    contact->mutable_collision2()->set_name("rover::chassis::collision");
    auto place = contact->add_position();
    place->set_x(2.5);
    place->set_z(0.3);
    contact->add_normal()->set_x(-1);
    contact->add_depth(0.001);
    contact->mutable_world()->set_name("yard");
    this->contacts.Publish(touched);

    msgs::Wind blows;
    blows.set_enable_wind(true);
    this->odd.Publish(blows);
  }

  private: int joints;
  private: ignition::transport::Node::Publisher clock, stats, poses, odometry, scan, image, model, odd, contacts;
};
}  // namespace

int main(int argc, char **argv)
{
  const int joints = argc > 2 && std::strcmp(argv[1], "--joints") == 0 ? std::atoi(argv[2]) : 2;
  std::signal(SIGTERM, End);
  std::signal(SIGINT, End);
  World world;
  ignition::transport::Node node;
  Voice voice(node, joints);

  std::function<void(const msgs::Twist &)> drive = [&](const msgs::Twist &twist) {
    std::lock_guard<std::mutex> lock(world.mutex);
    world.forward = twist.linear().x();
    world.turn = twist.angular().z();
    Say("drive " + std::to_string(world.forward) + " " + std::to_string(world.turn));
  };
  node.Subscribe("/model/rover/cmd_vel", drive);

  std::function<bool(msgs::Scene &)> scene = [](msgs::Scene &answer) {
    Say("scene");
    return Scene(answer);
  };
  node.Advertise("/world/yard/scene/info", scene);

  std::function<bool(const msgs::WorldControl &, msgs::Boolean &)> control =
      [&](const msgs::WorldControl &wanted, msgs::Boolean &answer) {
    std::lock_guard<std::mutex> lock(world.mutex);
    world.paused = wanted.pause();
    world.allowed += wanted.multi_step();
    Say(std::string("control ") + (wanted.pause() ? "pause " : "play ") + std::to_string(wanted.multi_step()));
    answer.set_data(true);
    return true;
  };
  node.Advertise("/world/yard/control", control);
  Say("ready");

  while (!over)
  {
    {
      std::lock_guard<std::mutex> lock(world.mutex);
      if (!world.paused || world.allowed > 0)
      {
        world.allowed -= world.paused ? 1 : 0;
        ++world.step;
        world.x += world.forward * std::cos(world.yaw) / kStepsASecond;
        world.yaw += world.turn / kStepsASecond;
      }
      voice.Speak(world);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1000 / kStepsASecond));
  }
  return 0;
}
