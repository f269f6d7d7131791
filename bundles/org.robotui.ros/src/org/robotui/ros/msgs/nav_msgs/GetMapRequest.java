package org.robotui.ros.msgs.nav_msgs;

import org.robotui.ros.message.RecordCodec;

/** Asks for the current map ({@code nav_msgs/GetMapRequest}). */
public record GetMapRequest() {

  /** Between records and bytes. */
  public static final RecordCodec<GetMapRequest> CODEC =
      RecordCodec.of("nav_msgs/GetMapRequest", in -> new GetMapRequest(), (m, out) -> { });
}
