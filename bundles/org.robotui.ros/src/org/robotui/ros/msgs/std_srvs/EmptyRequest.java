package org.robotui.ros.msgs.std_srvs;

import org.robotui.ros.message.RecordCodec;

/** Asks for an action that needs no arguments ({@code std_srvs/EmptyRequest}). */
public record EmptyRequest() {

  /** Between records and bytes. */
  public static final RecordCodec<EmptyRequest> CODEC =
      RecordCodec.of("std_srvs/EmptyRequest", in -> new EmptyRequest(), (m, out) -> { });
}
