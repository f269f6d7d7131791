// robotui-rt-ctl: asks a running robotui-rt, from a terminal or a test.
#include <getopt.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "ctl_push.h"
#include "ctl_table.h"
#include "ctl_trace.h"
#include "ctl_trajectory.h"
#include "robotui/rt/link/board.h"
#include "robotui/rt/link/state.h"

namespace {

namespace link = robotui::rt::link;
using namespace robotui::rt::supervisor;
using link::Client;

constexpr Client::Milliseconds kConnect{5000};
constexpr Client::Milliseconds kReply{5000};
constexpr Client::Milliseconds kReload{70000};
constexpr std::chrono::milliseconds kReferencePeriod{10};
constexpr double kTraceSeconds = 10;
constexpr double kLongestTrace = 600;

constexpr const char* kUsage = R"(robotui-rt-ctl [--name NAME] COMMAND
  list                         the plugins, their states and errors
  joints                       position, reference and owner of each joint, and what was cut or refused
  loops                        the loops of the HAL and the threads
  watch [SECONDS]              joints and loops, again and again
  switch PLUGIN 1|0 ...        start or stop a plugin; several are switched in the same cycle, or none is
  group [NAME]                 switch a group of the configuration likewise, or list them
  status PLUGIN                what it says about itself
  command PLUGIN WORDS...      tell it something
  trajectory FILE [PLUGIN]     take joints along the points of a file, and wait for the end (docs/rt-trajectories.md); PLUGIN is JointTrajectory
  trace [FILE] [--for SECONDS] what the loops do, cycle by cycle, as a file for Perfetto (docs/rt-tracing.md); trace.json and 10 s where nothing is said
  drives                       where each drive stands: disabled, enabling, enabled, fault, silent (docs/rt-canopen.md)
  recover                      bring drives back that a fault has disabled
  enable, disable              enable the drives that are disabled, or disable all; no plugin leads a joint then
  estop [on|off [NAME]]        how the emergency stops stand; press or release one of a simulation, or all
  push JOINT EFFORT | push LINK X Y Z, [--for SECONDS]
                               push a simulated robot, as a hand would: N m or N on a joint, N in the axes of the world on a link; 1 s where nothing is said
  reload PLUGIN                load its library and its parameters anew
  reference JOINT=POSITION... [--for SECONDS]
                               command joints as the master framework (the communication plugin must run)
Each says what happened: 0 where it is done, 1 where it is not, 2 where the command is not understood.
NAME is the robot's; it can be left out where one robot runs.
)";

struct Wrong : std::runtime_error {
  using std::runtime_error::runtime_error;
};

std::string onlyRobot() {
  std::vector<std::string> names;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(link::socketFolder(), none)) {
    if (entry.path().extension() == ".sock") {
      names.push_back(entry.path().stem().string());
    }
  }
  if (names.size() == 1) {
    return names.front();
  }
  throw Wrong(names.empty() ? "No robot runs here: start one with robotui-rt."
                            : "Several robots run here: choose one with --name.");
}

int print(const link::Reply& reply) {
  if (!reply.ok) {
    std::cerr << reply.text << '\n';
    return 1;
  }
  if (!reply.text.empty()) {
    std::cout << reply.text << '\n';
  }
  return 0;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) {
    text += (text.empty() ? "" : " ") + word;
  }
  return text;
}

int watch(Client& client, double seconds) {
  link::Attachment attachment = client.attach(kReply);
  const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  while (std::chrono::steady_clock::now() < until) {
    const link::Notice notice = client.notice(std::chrono::milliseconds(500));
    if (notice == link::Notice::kGone) {
      std::cerr << "The robot is gone.\n";
      return 1;
    }
    if (notice == link::Notice::kChanged) {
      attachment = client.attach(kReply);
    }
    std::cout << (isatty(STDOUT_FILENO) != 0 ? "\x1b[H\x1b[J" : "\n") << loopTable(attachment) << jointTable(attachment)
              << std::flush;
  }
  return 0;
}

std::uint32_t jointNamed(const link::BoardData& board, const std::string& name) {
  for (std::uint32_t i = 0; i < board.joints; ++i) {
    if (link::view(board.joint[i].name) == name) {
      return i;
    }
  }
  throw Wrong("The robot has no joint '" + name + "'.");
}

double numberOf(const std::string& text, const std::string& what) {
  double value = 0;
  const char* const behind = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), behind, value);
  if (error != std::errc() || end != behind || !std::isfinite(value)) {
    throw Wrong("'" + text + "' of " + what + " is no finite number.");
  }
  return value;
}

struct Wish {
  std::uint32_t joint;
  double position;
};

std::vector<Wish> wishesOf(const link::BoardData& board, const std::vector<std::string>& words) {
  std::vector<Wish> wishes;
  for (const std::string& word : words) {
    const std::size_t sign = word.find('=');
    if (sign == std::string::npos) {
      throw Wrong("A reference is JOINT=POSITION, not '" + word + "'.");
    }
    const std::uint32_t joint = jointNamed(board, word.substr(0, sign));
    wishes.push_back({joint, numberOf(word.substr(sign + 1), "the reference " + word)});
    const link::JointEntry& entry = board.joint[joint];
    if (wishes.back().position < entry.lower || wishes.back().position > entry.upper) {
      std::cerr << word << " is beyond the limits of the joint, " << entry.lower << " and " << entry.upper
                << ": it goes as far as that.\n";
    }
  }
  if (wishes.empty()) {
    throw Wrong("reference needs JOINT=POSITION, such as reference elbow=0.5 --for 2.");
  }
  return wishes;
}

// Where the joints are now that it is over: 0, or 1 where one did not obey.
int outcomeOf(const link::Attachment& attachment, const link::BoardData& board, const std::vector<Wish>& wishes) {
  auto frame = std::make_unique<link::FrameData>();
  link::StateReader reader(*attachment.state);
  for (int i = 0; i < 100 && reader.newest(*frame) != link::Read::kNew; ++i)
    std::this_thread::sleep_for(kReferencePeriod);
  int rc = 0;
  for (const Wish& wish : wishes) {
    const link::JointState& joint = frame->joints[wish.joint];
    const auto control = static_cast<link::Control>(joint.control);
    const bool obeyed = control == link::Control::kCommanded || control == link::Control::kHolding;
    (obeyed ? std::cout : std::cerr) << link::view(board.joint[wish.joint].name) << " is at " << joint.link_position
                                     << (obeyed ? "" : ", and did not obey: robotui-rt-ctl joints says why") << '\n';
    rc = obeyed ? rc : 1;
  }
  return rc;
}

// Whether a plugin follows references: who sends them to nobody must know it.
int sayWhoFollows(Client& client) {
  const link::Reply follower = client.request("follower", kReply);
  return follower.ok ? 0 : print(follower);
}

int sendReferences(Client& client, const std::vector<std::string>& words, double seconds) {
  const link::Attachment attachment = client.attach(kReply);
  auto board = std::make_unique<link::BoardData>();
  link::BoardReader(*attachment.board).read(*board);
  const std::vector<Wish> wishes = wishesOf(*board, words);
  std::vector<link::JointCommand> commands(board->joints);
  for (const Wish& wish : wishes) {
    commands[wish.joint].position = wish.position;
    commands[wish.joint].mode = link::kPosition;
  }
  if (const int rc = sayWhoFollows(client); rc != 0) return rc;
  if (const link::Reply taken = client.request("take 1", kReply); !taken.ok) return print(taken);
  const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  while (std::chrono::steady_clock::now() < until && client.reference(commands)) {
    std::this_thread::sleep_for(kReferencePeriod);
  }
  const int followed = sayWhoFollows(client);
  const int rc = followed != 0 ? followed : outcomeOf(attachment, *board, wishes);
  const link::Reply released = client.request("release", kReply);
  return released.ok ? rc : print(released);
}

// What became of a request that was granted.
std::string doneWords(const std::string& command, const std::vector<std::string>& words) {
  const std::string plugin = words.empty() ? std::string() : words.front();
  if (command == "switch" && words.size() > 1) return plugin + (words[1] == "1" ? " runs." : " is stopped.");
  if (command == "reload") return plugin + " is loaded anew, and stopped.";
  if (command == "drives") return "The HAL of this robot has no drives that are enabled and disabled.";
  if (command == "recover" || command == "enable" || command == "disable")
    return "The HAL is asked for it: what it says is in the log of robotui-rt.";
  if (command == "command") return plugin + " has taken it.";
  return "ok";
}

int group(Client& client, const std::vector<std::string>& words) {
  if (!words.empty()) return print(client.request("group " + joined(words), kReply));
  const link::Reply reply = client.request("groups", kReply);
  if (!reply.ok) return print(reply);
  std::istringstream lines(reply.text);
  std::string name;
  std::string start;
  std::string stop;
  while (std::getline(lines, name, '\t') && std::getline(lines, start, '\t') && std::getline(lines, stop))
    std::cout << std::left << std::setw(25) << name << (start.empty() ? "" : " starts " + start)
              << (stop.empty() ? "" : " stops " + stop) << '\n';
  if (reply.text.empty()) std::cout << "The configuration names no switch_groups.\n";
  return 0;
}

int ask(Client& client, const std::string& command, const std::vector<std::string>& words) {
  link::Reply reply =
      client.request(command + (words.empty() ? "" : " ") + joined(words), command == "reload" ? kReload : kReply);
  if (reply.ok && reply.text.empty()) reply.text = doneWords(command, words);
  return print(reply);
}

struct Stop {
  std::string state;  // released, pressed, unread
  std::string name;
};

std::vector<Stop> stopsOf(Client& client) {
  const link::Reply reply = client.request("stops", kReply);
  if (!reply.ok) throw std::runtime_error(reply.text);
  std::istringstream lines(reply.text);
  std::vector<Stop> stops;
  for (Stop stop; std::getline(lines, stop.state, '\t') && std::getline(lines, stop.name);) stops.push_back(stop);
  return stops;
}

void printStops(const std::vector<Stop>& stops) {
  for (const Stop& stop : stops)
    std::cout << std::left << std::setw(25) << stop.name << ' '
              << (stop.state == "unread" ? "cannot be read, which counts as pressed" : stop.state) << '\n';
  if (stops.empty()) std::cout << "This robot has no emergency stops.\n";
}

// Whether every one that is meant stands as it is to.
bool stand(const std::vector<Stop>& stops, const std::string& name, const std::string& state) {
  return std::all_of(stops.begin(), stops.end(),
                     [&](const Stop& stop) { return (!name.empty() && stop.name != name) || stop.state == state; });
}

void press(Client& client, const std::string& name, bool on) {
  const link::Reply asked = client.request((on ? "press 1 " : "press 0 ") + name, kReply);
  if (!asked.ok) throw std::runtime_error(asked.text);
  const auto until = std::chrono::steady_clock::now() + kReply;
  while (!stand(stopsOf(client), name, on ? "pressed" : "released")) {
    if (std::chrono::steady_clock::now() > until) throw std::runtime_error("The HAL did not obey in time.");
    std::this_thread::sleep_for(kReferencePeriod);
  }
}

int emergencyStop(Client& client, const std::vector<std::string>& words) {
  if (!words.empty()) {
    const bool on = words.front() == "on";
    if (!on && words.front() != "off") throw Wrong("estop needs on or off, not '" + words.front() + "'.");
    press(client, joined({words.begin() + 1, words.end()}), on);
  }
  printStops(stopsOf(client));
  return 0;
}

struct Call {
  std::string robot;
  double seconds = 0;
  std::string command;
  std::vector<std::string> words;
};

Call parse(int argc, char** argv) {
  const option known[] = {{"name", required_argument, nullptr, 'n'},
                          {"for", required_argument, nullptr, 'f'},
                          {"help", no_argument, nullptr, 'h'},
                          {nullptr, 0, nullptr, 0}};
  Call call;
  for (int key = 0; (key = getopt_long(argc, argv, "+n:h", known, nullptr)) != -1;) {
    switch (key) {
      case 'n': call.robot = optarg; break;
      case 'f': call.seconds = numberOf(optarg, "--for"); break;
      case 'h': call.command = "help"; break;
      default: throw Wrong(kUsage);
    }
  }
  for (int i = optind; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--for" && i + 1 < argc) {
      call.seconds = numberOf(argv[++i], "--for");
    } else if (call.command.empty()) {
      call.command = word;
    } else {
      call.words.push_back(word);
    }
  }
  return call;
}

int work(const Call& call) {
  if (call.command.empty()) {
    throw Wrong(kUsage);
  }
  if (call.command == "help") {
    std::cout << kUsage;
    return 0;
  }
  Client client(call.robot.empty() ? onlyRobot() : call.robot, kConnect);
  if (call.command == "list") {
    std::cout << pluginTable(client.attach(kReply));
  } else if (call.command == "joints") {
    std::cout << jointTable(client.attach(kReply));
  } else if (call.command == "loops") {
    std::cout << loopTable(client.attach(kReply));
  } else if (call.command == "watch") {
    return watch(client, call.words.empty() ? 1e9 : numberOf(call.words.front(), "watch"));
  } else if (call.command == "estop") {
    return emergencyStop(client, call.words);
  } else if (call.command == "group") {
    return group(client, call.words);
  } else if (call.command == "push") {
    return pushRobot(client, call.words, call.seconds > 0 ? call.seconds : 1);
  } else if (call.command == "trajectory") {
    if (call.words.empty()) throw Wrong("trajectory needs a file of points, such as trajectory wave.yaml");
    return runTrajectory(client, call.words.size() > 1 ? call.words[1] : "JointTrajectory", call.words.front());
  } else if (call.command == "trace") {
    if (call.seconds > kLongestTrace) throw Wrong("A trace is of at most 600 seconds.");
    return traceCycles(client, call.words.empty() ? "trace.json" : call.words.front(),
                       call.seconds > 0 ? call.seconds : kTraceSeconds);
  } else if (call.command == "reference") {
    return sendReferences(client, call.words, call.seconds > 0 ? call.seconds : 2);
  } else {
    return ask(client, call.command, call.words);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return work(parse(argc, argv));
  } catch (const Wrong& e) {
    std::cerr << e.what() << '\n';
    return 2;
  } catch (const std::exception& e) {
    std::cerr << e.what() << '\n';
    return 1;
  }
}
