package org.robotui.ros.msgs.roscpp;

import org.robotui.ros.message.RecordCodec;

/** Asks a node for its loggers ({@code roscpp/GetLoggersRequest}). */
public record GetLoggersRequest() {

  /** Between records and bytes. */
  public static final RecordCodec<GetLoggersRequest> CODEC =
      RecordCodec.of("roscpp/GetLoggersRequest", in -> new GetLoggersRequest(), (m, out) -> { });
}
