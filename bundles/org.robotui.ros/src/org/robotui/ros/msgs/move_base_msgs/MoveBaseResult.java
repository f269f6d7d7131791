package org.robotui.ros.msgs.move_base_msgs;

import org.robotui.ros.message.RecordCodec;

/** Ends a drive; says nothing ({@code move_base_msgs/MoveBaseResult}). */
public record MoveBaseResult() {

  /** Between records and bytes. */
  public static final RecordCodec<MoveBaseResult> CODEC =
      RecordCodec.of("move_base_msgs/MoveBaseResult", in -> new MoveBaseResult(), (m, out) -> { });
}
