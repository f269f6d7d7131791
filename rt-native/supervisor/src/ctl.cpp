// robotui-rt-ctl: asks a running robotui-rt, from a terminal or a test.
#include <getopt.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <thread>

#include "ctl_table.h"
#include "robotui/rt/link/board.h"

namespace {

namespace link = robotui::rt::link;
using namespace robotui::rt::supervisor;
using link::Client;

constexpr Client::Milliseconds kConnect{5000};
constexpr Client::Milliseconds kReply{5000};
constexpr Client::Milliseconds kReload{70000};
constexpr std::chrono::milliseconds kReferencePeriod{10};

constexpr const char* kUsage = R"(robotui-rt-ctl [--name NAME] COMMAND
  list                         the plugins, their states and errors
  joints                       position, reference and owner of each joint, and what was cut or refused
  loops                        the loops of the HAL and the threads
  watch [SECONDS]              joints and loops, again and again
  switch PLUGIN 1|0            start or stop a plugin
  status PLUGIN                what it says about itself
  command PLUGIN WORDS...      tell it something
  reload PLUGIN                load its library and its parameters anew
  reference JOINT=POSITION... [--for SECONDS]
                               command joints as the master framework (the communication plugin must run)
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

std::vector<link::JointCommand> references(const link::BoardData& board, const std::vector<std::string>& wishes) {
  std::vector<link::JointCommand> commands(board.joints);
  for (const std::string& wish : wishes) {
    const std::size_t sign = wish.find('=');
    if (sign == std::string::npos) {
      throw Wrong("A reference is JOINT=POSITION, not '" + wish + "'.");
    }
    auto& command = commands[jointNamed(board, wish.substr(0, sign))];
    command.position = std::stod(wish.substr(sign + 1));
    command.mode = link::kPosition;
  }
  return commands;
}

int sendReferences(Client& client, const std::vector<std::string>& wishes, double seconds) {
  const link::Attachment attachment = client.attach(kReply);
  auto board = std::make_unique<link::BoardData>();
  link::BoardReader(*attachment.board).read(*board);
  const auto commands = references(*board, wishes);
  if (const int rc = print(client.request("take 1", kReply)); rc != 0) {
    return rc;
  }
  const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  while (std::chrono::steady_clock::now() < until && client.reference(commands)) {
    std::this_thread::sleep_for(kReferencePeriod);
  }
  return print(client.request("release", kReply));
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
      case 'f': call.seconds = std::stod(optarg); break;
      default: throw Wrong(kUsage);
    }
  }
  for (int i = optind; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--for" && i + 1 < argc) {
      call.seconds = std::stod(argv[++i]);
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
  Client client(call.robot.empty() ? onlyRobot() : call.robot, kConnect);
  if (call.command == "list") {
    std::cout << pluginTable(client.attach(kReply));
  } else if (call.command == "joints") {
    std::cout << jointTable(client.attach(kReply));
  } else if (call.command == "loops") {
    std::cout << loopTable(client.attach(kReply));
  } else if (call.command == "watch") {
    return watch(client, call.words.empty() ? 1e9 : std::stod(call.words.front()));
  } else if (call.command == "reference") {
    return sendReferences(client, call.words, call.seconds > 0 ? call.seconds : 2);
  } else {
    const std::string words = call.command + (call.words.empty() ? "" : " ") + joined(call.words);
    return print(client.request(words, call.command == "reload" ? kReload : kReply));
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
