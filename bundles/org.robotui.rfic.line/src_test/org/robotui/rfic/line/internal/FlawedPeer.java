package org.robotui.rfic.line.internal;

import java.time.Duration;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;

/** The same robot, for a robot interface with a flaw. What such a one never does is not waited for long. */
final class FlawedPeer extends LinePeer {

  private final Flaw flaw;

  FlawedPeer(Flaw flaw) {
    this.flaw = flaw;
  }

  @Override
  public Rfic create(RficContext context) {
    return new FlawedRfic(context, port(), flaw);
  }

  @Override
  public Duration patience() {
    return flaw == Flaw.NONE ? super.patience() : Duration.ofSeconds(4);
  }
}
