package org.robotui.sim.internal.message;

import org.robotui.message.ros.std_msgs.Header;

/**
 * The number and the time of a message.
 *
 * @param sequence counts the messages of one topic
 * @param nanos when it was measured, nanoseconds
 */
public record Stamp(long sequence, long nanos) {
  public Header header(String frame) {
    return new Header(sequence, nanos, frame);
  }
}
