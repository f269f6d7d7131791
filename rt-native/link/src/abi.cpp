#include "robotui/rt/link/abi.h"

#include <string_view>

namespace robotui::rt::link {
namespace {

constexpr int kMostFacts = 64;  // a list without an end is not read for ever

const AbiFact* find(const AbiFact* facts, std::string_view name) {
  for (int i = 0; i < kMostFacts && facts[i].name != nullptr; ++i) {
    if (facts[i].name == name) return &facts[i];
  }
  return nullptr;
}

std::string valueOf(const AbiFact& fact) { return fact.before + std::to_string(fact.number) + fact.behind; }

}  // namespace

std::string abiDifference(const std::string& library, const AbiFact* has, const AbiFact* wants) {
  for (const AbiFact* wanted = wants; wanted->name != nullptr; ++wanted) {
    const AbiFact* found = find(has, wanted->name);
    const std::string there = found == nullptr ? "(not said)" : valueOf(*found);
    if (there != valueOf(*wanted)) {
      return library + " does not fit this program: it was built with " + wanted->name + " " + there +
             ", and this program with " + wanted->name + " " + valueOf(*wanted) + ". Build it again " + wanted->remedy;
    }
  }
  return {};
}

}  // namespace robotui::rt::link
