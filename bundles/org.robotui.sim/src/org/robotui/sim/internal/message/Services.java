package org.robotui.sim.internal.message;

import org.robotui.message.ros.nav_msgs.GetMapRequest;
import org.robotui.message.ros.nav_msgs.GetMapResponse;
import org.robotui.message.ros.nav_msgs.OccupancyGrid;
import org.robotui.message.ros.std_srvs.EmptyRequest;
import org.robotui.message.ros.std_srvs.EmptyResponse;
import org.robotui.message.ros.std_srvs.SetBoolRequest;
import org.robotui.message.ros.std_srvs.SetBoolResponse;
import org.robotui.message.ros.std_srvs.TriggerRequest;
import org.robotui.message.ros.std_srvs.TriggerResponse;
import org.robotui.sim.internal.Command;
import org.robotui.sim.internal.Simulation;

/** Offers what can be called. */
final class Services {
  private final Simulation simulation;

  Services(MessageNode node, Simulation simulation, OccupancyGrid map) {
    this.simulation = simulation;
    node.service("reset", "std_srvs/Empty", EmptyRequest.class, EmptyResponse.class, request -> reset());
    node.service("motors", "std_srvs/SetBool", SetBoolRequest.class, SetBoolResponse.class, this::motors);
    node.service("stop", "std_srvs/Trigger", TriggerRequest.class, TriggerResponse.class, request -> stop());
    node.service("static_map", "nav_msgs/GetMap", GetMapRequest.class, GetMapResponse.class,
        request -> new GetMapResponse(map));
  }

  private EmptyResponse reset() {
    if (!simulation.submit(new Command.Reset())) {
      throw new IllegalStateException("the robot is busy with other commands");
    }
    return new EmptyResponse();
  }

  private SetBoolResponse motors(SetBoolRequest request) {
    boolean taken = simulation.submit(new Command.Motors(request.data()));
    return new SetBoolResponse(taken, taken ? "motors " + (request.data() ? "on" : "off") : "busy");
  }

  private TriggerResponse stop() {
    boolean taken = simulation.submit(new Command.Stop());
    return new TriggerResponse(taken, taken ? "stopped" : "busy");
  }
}
