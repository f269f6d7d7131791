package org.robotui.uic.jointcontrol.internal;

import java.util.List;
import org.robotui.api.port.Arity;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.Port;
import org.robotui.api.port.StreamPort;
import org.robotui.data.joint.JointCommand;
import org.robotui.data.joint.JointControl;
import org.robotui.data.joint.JointModel;

/** The ports of the view. */
final class JointControlPorts {
  static final StreamPort<JointControl> CONTROL =
      new StreamPort<>("control", JointControl.class, Arity.ONE,
          "how the joints are driven: references beside what is measured");
  static final StreamPort<JointModel> MODEL =
      new StreamPort<>("model", JointModel.class, Arity.ONE, "the joints with their limits, and their chains");
  static final CommandPort<JointCommand> COMMAND =
      new CommandPort<>("joint_command", JointCommand.class, Arity.OPTIONAL,
          "the joints to drive, once the user has taken control");

  static final List<Port> ALL = List.of(CONTROL, MODEL, COMMAND);

  private JointControlPorts() {}
}
