package org.robotui.rtps.internal.participant;

import org.robotui.rtps.EndpointKind;
import org.robotui.rtps.Guid;
import org.robotui.rtps.internal.endpoint.Change;

/** Takes what participants say by their built-in writers, on the receiving thread. */
interface Hearing {

  /** One has an endpoint, or has it no more. */
  void endpoint(Guid writer, Change change, EndpointKind kind);

  /** One is alive. */
  void alive(Guid writer, Change change);
}
