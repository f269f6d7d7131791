#include "mujoco_world.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

#include "robotui/rt/link/words.h"

namespace robotui::rt::hal {
namespace {

constexpr int kMemory = 32 << 20;  // for contacts: taken once

void place(const Eigen::Isometry3d& at, double (&pos)[3], double (&quat)[4]) {
  Eigen::Map<Eigen::Vector3d>(static_cast<double*>(pos)) = at.translation();
  const Eigen::Quaterniond q(at.linear());
  quat[0] = q.w();
  quat[1] = q.x();
  quat[2] = q.y();
  quat[3] = q.z();
}

class WorldBuilder {
 public:
  WorldBuilder(const config::RobotDescription& robot, const MujocoSettings& settings)
      : robot_(robot), settings_(settings), tree_(buildRigidTree(robot, sensorLinks(robot))),
        mujoco_(addTree(tree_, robot, isFree())) {}

  MujocoWorld build(double period) {
    checkMeshes();
    setOptions(period / settings_.steps);
    if (settings_.floor) addFloor();
    for (const auto& shape : tree_.shapes) addShape(shape);
    for (std::size_t i = 0; i < robot_.joints.size(); ++i) addDrive(i);
    for (const auto& imu : robot_.imus) addImu(imu);
    for (const auto& sensor : robot_.force_torques) addForceTorque(sensor);
    MujocoWorld world;
    world.mesh_links = tree_.mesh_links;
    world.model = compile(mujoco_, robot_.name);
    world.data = makeData(*world.model);
    findParts(world);
    takePosture(world);
    tuneDrives(world);
    return world;
  }

 private:
  // A sensor measures what goes through a joint: what is beyond must be a body of its own.
  static std::set<std::string> sensorLinks(const config::RobotDescription& robot) {
    std::set<std::string> links;
    for (const auto& sensor : robot.force_torques) links.insert(sensor.link);
    return links;
  }

  bool isFree() const { return robot_.floating_base && !settings_.fix_base; }
  // What stands on the floor by a mesh would fall through it, and all that is told of it would be wrong.
  void checkMeshes() const {
    if (tree_.mesh_links.empty() || settings_.ignore_meshes || !settings_.floor || !isFree()) return;
    throw std::runtime_error(
        "The simulation has no collisions of meshes, and this robot stands free on the floor with meshes (" +
        link::listed(tree_.mesh_links).substr(0, kNamed) +
        "): it would fall through it. Give these links boxes, spheres or cylinders in <collision>, hang the robot up "
        "(HALInterface.params: {fix_base: true}), or go on with {ignore_meshes: true}.");
  }

  mjSpec* spec() { return mujoco_.spec.get(); }

  void setOptions(double step) {
    mjOption& option = spec()->option;
    option.timestep = step;
    option.integrator = mjINT_IMPLICITFAST;  // stiff damping of drives
    option.disableflags |= mjDSBL_AUTORESET;
    spec()->memory = kMemory;
  }

  void addFloor() {
    mjsGeom* floor = mjs_addGeom(mjs_findBody(spec(), "world"), nullptr);
    floor->type = mjGEOM_PLANE;
    floor->size[2] = 0.05;
    floor->contype = 0;
    floor->conaffinity = 1;
  }

  // Parts of the robot touch the floor, not each other: primitives overlap at the joints.
  void addShape(const CollisionShape& shape) {
    mjsGeom* geom = mjs_addGeom(mujoco_.bodies[static_cast<std::size_t>(shape.body)], nullptr);
    geom->type = shape.kind == CollisionShape::Kind::kBox      ? mjGEOM_BOX
                 : shape.kind == CollisionShape::Kind::kSphere ? mjGEOM_SPHERE
                                                               : mjGEOM_CYLINDER;
    Eigen::Map<Eigen::Vector3d>(static_cast<double*>(geom->size)) = shape.size;
    place(shape.in_body, geom->pos, geom->quat);
    geom->contype = 1;
    geom->conaffinity = 0;
    geom->mass = 0;
  }

  void addDrive(std::size_t i) {
    const auto& description = robot_.joints[i];
    mjsJoint& joint = *mujoco_.joints[i];
    joint.armature = settings_.armature * description.effort;
    joint.limited = std::isfinite(description.lower) ? mjLIMITED_TRUE : mjLIMITED_FALSE;
    joint.range[0] = description.lower;
    joint.range[1] = description.upper;
    mjsActuator* drive = mjs_addActuator(spec(), nullptr);
    mjs_setString(drive->name, description.name.c_str());
    mjs_setString(drive->target, description.name.c_str());
    drive->trntype = mjTRN_JOINT;
    drive->gaintype = mjGAIN_FIXED;
    drive->biastype = mjBIAS_AFFINE;
    drive->gainprm[0] = 1;
    drive->forcelimited = mjLIMITED_TRUE;
    drive->forcerange[0] = -description.effort;
    drive->forcerange[1] = description.effort;
  }

  void addSite(const std::string& name, const std::string& link) {
    const LinkFrame& frame = tree_.links.at(link);
    mjsSite* site = mjs_addSite(mujoco_.bodies[static_cast<std::size_t>(frame.body)], nullptr);
    mjs_setString(site->name, name.c_str());
    place(frame.in_body, site->pos, site->quat);
  }

  void addSensor(mjtSensor type, const std::string& site) {
    mjsSensor* sensor = mjs_addSensor(spec());
    sensor->type = type;
    sensor->objtype = mjOBJ_SITE;
    mjs_setString(sensor->objname, site.c_str());
    sensors_.push_back(sensor);
  }

  void addImu(const config::SensorDescription& imu) {
    const std::string site = "imu " + imu.name;
    addSite(site, imu.link);
    for (const mjtSensor type : {mjSENS_FRAMEQUAT, mjSENS_GYRO, mjSENS_ACCELEROMETER}) addSensor(type, site);
  }

  void addForceTorque(const config::SensorDescription& force_torque) {
    const std::string site = "ft " + force_torque.name;
    addSite(site, force_torque.link);
    for (const mjtSensor type : {mjSENS_FORCE, mjSENS_TORQUE}) addSensor(type, site);
  }

  // Three sensors an IMU, then two a force-torque sensor; those of one site lie one behind the other.
  void findParts(MujocoWorld& world) const {
    for (const auto& joint : robot_.joints) {
      const int id = mj_name2id(world.model.get(), mjOBJ_JOINT, joint.name.c_str());
      const int drive = mj_name2id(world.model.get(), mjOBJ_ACTUATOR, joint.name.c_str());
      world.joints.push_back({world.model->jnt_qposadr[id], world.model->jnt_dofadr[id], drive, 0, 0});
    }
    for (const auto& [name, frame] : tree_.links) {
      const Eigen::Vector3d at = frame.in_body.translation();
      const int body = mjs_getId(mujoco_.bodies[static_cast<std::size_t>(frame.body)]->element);
      const bool is_fixed = world.model->body_weldid[body] == 0;
      world.links.emplace(name, MujocoLink{body, {at.x(), at.y(), at.z()}, is_fixed});
    }
    const auto address = [&](std::size_t sensor) {
      return world.model->sensor_adr[mjs_getId(sensors_[sensor]->element)];
    };
    for (std::size_t i = 0; i < robot_.imus.size(); ++i) world.imus.push_back(address(3 * i));
    const std::size_t first = 3 * robot_.imus.size();
    for (std::size_t i = 0; i < robot_.force_torques.size(); ++i) world.force_torques.push_back(address(first + 2 * i));
  }

  void takePosture(MujocoWorld& world) const {
    for (std::size_t i = 0; i < robot_.joints.size(); ++i) {
      world.data->qpos[world.joints[i].position] = std::clamp(0.0, robot_.joints[i].lower, robot_.joints[i].upper);
    }
    for (const auto& posture : robot_.postures) {
      if (posture.name == settings_.posture) takeAngles(posture, world);
    }
    mj_forward(world.model.get(), world.data.get());
    if (!robot_.floating_base) return;
    const double height = settings_.base_height >= 0 ? settings_.base_height : std::max(0.0, -lowest(world));
    if (isFree())
      world.data->qpos[2] = height;
    else
      world.model->body_pos[3 * mjs_getId(mujoco_.bodies[0]->element) + 2] = height + kHanging;
    mj_forward(world.model.get(), world.data.get());
  }

  void takeAngles(const config::Posture& posture, MujocoWorld& world) const {
    for (const auto& [name, angle] : posture.joints) {
      const auto joint = std::find_if(robot_.joints.begin(), robot_.joints.end(),
                                      [&wanted = name](const auto& j) { return j.name == wanted; });
      if (joint != robot_.joints.end())
        world.data->qpos[world.joints[static_cast<std::size_t>(joint - robot_.joints.begin())].position] = angle;
    }
  }

  static double lowest(const MujocoWorld& world) {
    double least = std::numeric_limits<double>::infinity();
    const mjModel& model = *world.model;
    for (int i = 0; i < model.ngeom; ++i) {
      if (model.geom_type[i] != mjGEOM_PLANE)
        least = std::min(least, world.data->geom_xpos[3 * i + 2] - reach(model, *world.data, i));
    }
    return std::isfinite(least) ? least : 0;
  }

  // How far a shape goes down from its middle.
  static double reach(const mjModel& model, const mjData& data, int geom) {
    const mjtNum* size = model.geom_size + 3 * geom;
    const mjtNum* down = data.geom_xmat + 9 * geom + 6;
    if (model.geom_type[geom] == mjGEOM_SPHERE) return size[0];
    if (model.geom_type[geom] == mjGEOM_BOX)
      return std::abs(down[0]) * size[0] + std::abs(down[1]) * size[1] + std::abs(down[2]) * size[2];
    return std::hypot(down[0], down[1]) * size[0] + std::abs(down[2]) * size[1];
  }

  // Damping of the ratio that is asked for the inertia that the joint has in this posture.
  void tuneDrives(MujocoWorld& world) const {
    const int n = world.model->nv;
    std::vector<mjtNum> inertia(static_cast<std::size_t>(n) * static_cast<std::size_t>(n));
    mj_fullM(world.model.get(), inertia.data(), world.data->qM);
    for (std::size_t i = 0; i < world.joints.size(); ++i) {
      MujocoJoint& joint = world.joints[i];
      const double moved = inertia[static_cast<std::size_t>(joint.dof) * static_cast<std::size_t>(n + 1)];
      joint.stiffness = settings_.drive_stiffness * robot_.joints[i].effort;
      joint.damping = 2 * settings_.drive_damping * std::sqrt(joint.stiffness * moved);
    }
  }

  static constexpr std::size_t kNamed = 120;  // characters of names of links
  static constexpr double kHanging = 0.3;     // m between the floor and a robot that hangs

  const config::RobotDescription& robot_;
  const MujocoSettings& settings_;
  RigidTree tree_;
  MujocoTree mujoco_;
  std::vector<mjsSensor*> sensors_;
};

}  // namespace

MujocoWorld buildMujocoWorld(const config::RobotDescription& robot, const MujocoSettings& settings, double period) {
  return WorldBuilder(robot, settings).build(period);
}

}  // namespace robotui::rt::hal
