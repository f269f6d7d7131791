package org.robotui.uic.connections.internal;

import java.util.List;
import org.robotui.api.bridge.BridgeStatus;
import org.robotui.api.bridge.Bridges;

/** Carries nothing. */
final class FakeBridges implements Bridges {
  static final Bridges NONE = new FakeBridges();

  @Override
  public void start() {
    // there is nothing to carry
  }

  @Override
  public void stop() {
    // nothing was started
  }

  @Override
  public List<BridgeStatus> statuses() {
    return List.of();
  }
}
