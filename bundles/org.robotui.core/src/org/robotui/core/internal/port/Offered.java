package org.robotui.core.internal.port;

import org.robotui.api.host.PortStatus;
import org.robotui.api.port.Offer;
import org.robotui.api.port.Port;
import org.robotui.api.port.SourceId;
import org.robotui.core.internal.time.NanoClock;

/** A port of a robot interface, as core holds it. */
public interface Offered extends Offer {
  /** Which it is. */
  SourceId id();

  /** As offered. */
  Port port();

  /**
   * How it is doing. The time is taken after the newest value: one that comes meanwhile would be from after that
   * moment.
   *
   * @param clock monotonic
   */
  PortStatus status(NanoClock clock);
}
