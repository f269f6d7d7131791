package org.robotui.sim.internal.ros;

import org.robotui.message.RecordCodec;
import org.robotui.ros.Parameters;
import org.robotui.ros.Publisher;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.RosNode;
import org.robotui.ros.ServiceException;
import org.robotui.ros.XmlRpcValue;
import org.robotui.ros.msgs.StandardServices;
import org.robotui.ros.msgs.dynamic_reconfigure.Config;
import org.robotui.ros.msgs.dynamic_reconfigure.ConfigDescription;
import org.robotui.ros.msgs.dynamic_reconfigure.ReconfigureRequest;
import org.robotui.ros.msgs.dynamic_reconfigure.ReconfigureResponse;
import org.robotui.sim.internal.Command;
import org.robotui.sim.internal.Simulation;
import org.robotui.sim.internal.Tuning;

/** Lets others change limits and habits while the robot runs, as servers of dynamic_reconfigure do. */
final class Tuner {
  private final Simulation simulation;
  private final Parameters parameters;
  private final Publisher<Config> updates;
  private Tuning tuning;

  Tuner(RosNode node, Simulation simulation) {
    this.simulation = simulation;
    parameters = node.parameters();
    tuning = simulation.state().tuning();
    node.publisher("~parameter_descriptions", RecordCodec.of(ConfigDescription.class), PublisherOptions.latched())
        .publish(TuningMessages.description(tuning));
    updates = node.publisher("~parameter_updates", RecordCodec.of(Config.class), PublisherOptions.latched());
    updates.publish(TuningMessages.config(tuning));
    node.serviceServer("~set_parameters", StandardServices.RECONFIGURE, (request, caller) -> set(request));
  }

  private synchronized ReconfigureResponse set(ReconfigureRequest request) throws ServiceException {
    Tuning wish = TuningMessages.merge(tuning, request.config());
    if (!simulation.submit(new Command.Tune(wish))) {
      throw new ServiceException("the robot is busy with other commands");
    }
    tuning = wish;
    Config now = TuningMessages.config(wish);
    now.doubles().forEach(each -> parameters.set("~" + each.name(), new XmlRpcValue.Real(each.value())));
    updates.publish(now);
    return new ReconfigureResponse(now);
  }
}
