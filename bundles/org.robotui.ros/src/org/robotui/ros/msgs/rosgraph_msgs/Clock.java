package org.robotui.ros.msgs.rosgraph_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.message.Stamps;

/**
 * The simulated time ({@code rosgraph_msgs/Clock}).
 *
 * @param clock now, nanoseconds since the epoch of the sender's clock
 */
public record Clock(long clock) {

  /** Between records and bytes. */
  public static final RecordCodec<Clock> CODEC =
      RecordCodec.of("rosgraph_msgs/Clock", Clock::read, Clock::write);

  private static Clock read(MessageReader in) throws MessageException {
    return new Clock(in.time("clock"));
  }

  private static void write(Clock m, MessageWriter out) {
    Stamps.write(m.clock, out);
  }
}
