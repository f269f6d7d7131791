package org.robotui.sim.internal.ros;

import org.robotui.message.ros.std_msgs.Header;

/**
 * The number and the time of a message.
 *
 * @param sequence counts the messages of one topic
 * @param nanos when it was measured, nanoseconds
 */
record Stamp(long sequence, long nanos) {
  Header header(String frame) {
    return new Header(sequence, nanos, frame);
  }
}
