package org.robotui.ros2;

import java.nio.ByteBuffer;
import java.util.Optional;
import java.util.OptionalLong;
import org.robotui.message.description.TypeHash;
import org.robotui.message.description.TypeName;
import org.robotui.ros2.name.Ros2Name;
import org.robotui.rtps.Guid;

/**
 * How a message came in.
 *
 * @param node the publishing node; empty while its process has not said which it is
 * @param publisher the publishing writer
 * @param sequence the publisher's number of the message
 * @param receiveNanos when the message was complete, by {@link System#nanoTime()}
 * @param sourceNanos when it was published by the clock of the publisher's machine, nanoseconds since 1970
 * @param raw the message's bytes with their encapsulation, read only
 * @param type the type
 * @param hash the sum of the type that the publisher announced
 * @param kept whether the publisher keeps messages for late subscribers
 */
public record Ros2Reception(Optional<Ros2Name> node, Guid publisher, long sequence, long receiveNanos,
    OptionalLong sourceNanos, ByteBuffer raw, TypeName type, Optional<TypeHash> hash, boolean kept) {

  /**
   * The publisher as a user knows it.
   *
   * @return the name of its node, or that of its writer
   */
  public String from() {
    return node.map(Ros2Name::text).orElseGet(publisher::toString);
  }
}
