#include "chain_frame.h"

#include "chosen_joints.h"

namespace robotui::rt::plugins {
namespace {

int indexIn(const ModelInterface& model, const std::string& joint) {
  int index = 0;
  while (index < model.getJointNum() && model.joint(index).name() != joint) ++index;
  return index;
}

}  // namespace

bool ChainFrame::find(Setup& setup, const config::Reader& params, const ModelInterface& model) {
  const auto chains = setup.robot().chains();
  const auto named = params.find("chain");
  if (!named && chains.size() != 1) {
    setup.fail("The robot has " + std::to_string(chains.size()) + " chains: say with `chain` whose tip is to move.");
    return false;
  }
  KinematicChain* chain = named ? setup.robot().findChain(named->text()) : &chains.front();
  if (chain == nullptr) named->fail("is no chain of the SRDF");
  base_name_ = chain->baseLink();
  tip_name_ = chain->tipLink();
  base_ = model.findLink(base_name_);
  tip_ = model.findLink(tip_name_);
  for (int i = 0; i < chain->size(); ++i) {
    joints_.push_back(&chain->joint(i));
    in_model_.push_back(indexIn(model, chain->joint(i).name()));
  }
  whole_.setZero(6, model.getDofs());
  reduced_.setZero(6, chain->size());
  setup.claim(namesOf(joints_));
  return true;
}

Eigen::Isometry3d ChainFrame::tip(const ModelInterface& model) const noexcept {
  Eigen::Isometry3d base;
  Eigen::Isometry3d tip;
  model.getPose(base_, base);
  model.getPose(tip_, tip);
  return base.inverse(Eigen::Isometry) * tip;
}

const ChainFrame::Jacobian& ChainFrame::jacobian(const ModelInterface& model) noexcept {
  Eigen::Isometry3d base;
  model.getPose(base_, base);
  model.getJacobian(tip_, whole_);
  const Eigen::Matrix3d to_base = base.linear().transpose();
  const Eigen::Index offset = whole_.cols() - model.getJointNum();
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const Eigen::Matrix<double, 6, 1> column = whole_.col(offset + in_model_[i]);
    reduced_.col(static_cast<Eigen::Index>(i)) << to_base * column.head<3>(), to_base * column.tail<3>();
  }
  return reduced_;
}

}  // namespace robotui::rt::plugins
