package org.robotui.rfic.yarp.internal.feed;

import java.util.Map;
import java.util.Optional;
import org.robotui.api.port.CommandSink;
import org.robotui.data.joint.JointCommand;
import org.robotui.rfic.yarp.internal.convert.BoardModel;

/** A control board as one part of a robot that has several. */
interface BoardPart {
  /** Its joints, once they are known. */
  Optional<BoardModel> model();

  /** Where its joints were sent, by their numbers, SI units. */
  Map<Integer, Double> targets();

  /** Drives its joints. */
  CommandSink<JointCommand> driver();
}
