package org.robotui.ros.msgs.std_srvs;

import org.robotui.ros.message.RecordCodec;

/** Triggers an action ({@code std_srvs/TriggerRequest}). */
public record TriggerRequest() {

  /** Between records and bytes. */
  public static final RecordCodec<TriggerRequest> CODEC =
      RecordCodec.of("std_srvs/TriggerRequest", in -> new TriggerRequest(), (m, out) -> { });
}
