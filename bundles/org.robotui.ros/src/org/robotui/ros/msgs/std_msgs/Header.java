package org.robotui.ros.msgs.std_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.message.Stamps;

/**
 * When a message was made and in which frame its data are ({@code std_msgs/Header}).
 *
 * @param seq     counter of the publisher, starting at any number
 * @param stamp   when the data were measured, nanoseconds since the epoch of the sender's clock
 * @param frameId the frame of the data; empty where there is none
 */
public record Header(long seq, long stamp, String frameId) {

  /** Between records and bytes. */
  public static final RecordCodec<Header> CODEC =
      RecordCodec.of("std_msgs/Header", Header::read, Header::write);

  private static Header read(MessageReader in) throws MessageException {
    return new Header(in.uint32("seq"), in.time("stamp"), in.string("frame_id"));
  }

  private static void write(Header m, MessageWriter out) {
    out.i32((int) m.seq);
    Stamps.write(m.stamp, out);
    out.string(m.frameId);
  }
}
