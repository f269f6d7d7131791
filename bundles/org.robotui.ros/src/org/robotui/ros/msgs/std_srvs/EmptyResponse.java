package org.robotui.ros.msgs.std_srvs;

import org.robotui.ros.message.RecordCodec;

/** Says that the action was done ({@code std_srvs/EmptyResponse}). */
public record EmptyResponse() {

  /** Between records and bytes. */
  public static final RecordCodec<EmptyResponse> CODEC =
      RecordCodec.of("std_srvs/EmptyResponse", in -> new EmptyResponse(), (m, out) -> { });
}
