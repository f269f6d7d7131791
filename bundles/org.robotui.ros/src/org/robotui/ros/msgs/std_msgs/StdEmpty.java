package org.robotui.ros.msgs.std_msgs;

import org.robotui.ros.message.RecordCodec;

/** A message without content ({@code std_msgs/Empty}). */
public record StdEmpty() {

  /** Between records and bytes. */
  public static final RecordCodec<StdEmpty> CODEC =
      RecordCodec.of("std_msgs/Empty", in -> new StdEmpty(), (m, out) -> { });
}
