package org.robotui.core.internal.life;

import org.robotui.api.host.RuicState;

/**
 * How a component or a RUIC is doing.
 *
 * @param state its life cycle
 * @param reason a sentence where it failed, else empty
 */
record Health(RuicState state, String reason) {
  static final Health ADDED = new Health(RuicState.ADDED, "");
  static final Health RUNNING = new Health(RuicState.INITIALIZED, "");

  static Health failed(String reason) {
    return new Health(RuicState.FAILED, reason);
  }

  boolean isFailed() {
    return state == RuicState.FAILED;
  }
}
