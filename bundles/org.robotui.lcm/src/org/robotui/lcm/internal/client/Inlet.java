package org.robotui.lcm.internal.client;

import org.robotui.lcm.LcmMessage;

/** Where a link brings what it received. */
public interface Inlet {

  /** Whether anybody subscribed to a channel: if not, its messages need not be put together. */
  boolean wants(String channel);

  /** Brings a message. */
  void deliver(LcmMessage message);

  /** Where what happened is counted. */
  Counters counters();
}
