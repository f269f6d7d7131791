#include "robotui/rt/supervisor/client_requests.h"

#include "quoted.h"
#include "robotui/rt/link/clock.h"

namespace robotui::rt::supervisor {

void ClientRequests::serve(std::uint64_t client, const link::Packet& packet) {
  try {
    dispatch(client, packet);
  } catch (const std::exception& e) {
    log_.error(std::string("A request could not be served: ") + e.what());
    replies_.answer(client, std::string("This could not be done: ") + e.what());
  }
}

void ClientRequests::dispatch(std::uint64_t client, const link::Packet& packet) {
  const std::string_view verb = packet.verb();
  const std::string_view rest = packet.rest();
  if (verb == "reference") {
    master_.reference(client, rest);
    return;
  }
  log_.detail("client " + std::to_string(client) + " asks: " + packet.text.substr(0, 200));
  if (verb == "attach") {
    robot_.attach(client);
  } else if (verb == "switch") {
    plugins_.switchPlugin(client, rest);
  } else if (verb == "group") {
    groups_.switchGroup(client, rest);
  } else if (verb == "groups") {
    groups_.list(client);
  } else if (verb == "reload") {
    plugins_.reload(client, rest);
  } else if (verb == "command") {
    plugins_.command(client, rest);
  } else if (verb == "status") {
    plugins_.status(client, rest);
  } else if (verb == "trajectory") {
    plugins_.trajectory(client, rest);
  } else if (verb == "tasks") {
    plugins_.tasks(client, rest);
  } else if (verb == "take") {
    master_.take(client, rest);
  } else if (verb == "release") {
    master_.release(client);
  } else if (verb == "follower") {
    master_.follower(client);
  } else if (verb == "describe") {
    robot_.describe(client, rest);
  } else if (verb == "recover") {
    robot_.recover(client);
  } else if (verb == "enable") {
    robot_.enable(client);
  } else if (verb == "disable") {
    robot_.disable(client);
  } else if (verb == "drives") {
    robot_.drives(client);
  } else if (verb == "stops") {
    robot_.stops(client);
  } else if (verb == "press") {
    robot_.press(client, rest);
  } else if (verb == "push") {
    pushes_.push(client, rest, link::now());
  } else {
    replies_.answer(
        client, "The request " + quoted(verb) +
                    " is not known. There are: attach, switch, group, groups, reload, command, status, trajectory, "
                    "tasks, take, "
                    "release, follower, describe, drives, recover, enable, disable, stops, press, push, reference.");
  }
}

}  // namespace robotui::rt::supervisor
