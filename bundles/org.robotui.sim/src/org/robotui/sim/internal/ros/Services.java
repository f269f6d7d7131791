package org.robotui.sim.internal.ros;

import org.robotui.message.ros.nav_msgs.GetMapResponse;
import org.robotui.message.ros.nav_msgs.OccupancyGrid;
import org.robotui.message.ros.std_srvs.EmptyResponse;
import org.robotui.message.ros.std_srvs.SetBoolRequest;
import org.robotui.message.ros.std_srvs.SetBoolResponse;
import org.robotui.message.ros.std_srvs.TriggerResponse;
import org.robotui.ros.RosNode;
import org.robotui.ros.ServiceException;
import org.robotui.ros.msgs.StandardServices;
import org.robotui.sim.internal.Command;
import org.robotui.sim.internal.Simulation;

/** Offers what can be called. */
final class Services {
  private final Simulation simulation;

  Services(RosNode node, Simulation simulation, OccupancyGrid map) {
    this.simulation = simulation;
    node.serviceServer("reset", StandardServices.EMPTY, (request, caller) -> reset());
    node.serviceServer("motors", StandardServices.SET_BOOL, (request, caller) -> motors(request));
    node.serviceServer("stop", StandardServices.TRIGGER, (request, caller) -> stop());
    node.serviceServer("static_map", StandardServices.GET_MAP, (request, caller) -> new GetMapResponse(map));
  }

  private EmptyResponse reset() throws ServiceException {
    if (!simulation.submit(new Command.Reset())) {
      throw new ServiceException("the robot is busy with other commands");
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
