package org.robotui.roblets.internal;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import org.robotui.roblets.tree.BodyElement;
import org.robotui.roblets.wire.BodyDatagram;
import org.robotui.roblets.wire.DatagramKind;

/**
 * Makes the datagrams of one run of a sender for one receiver, which sees by their numbers what it has missed. A later
 * run has a greater number, also within one millisecond.
 */
public final class SenderRun {
  private final String name;
  private final long run;
  private final AtomicLong sequence = new AtomicLong();

  private SenderRun(String name, long run) {
    this.name = name;
    this.run = run;
  }

  public static SenderRun of(String name) {
    return new SenderRun(name, System.currentTimeMillis());
  }

  /** What the next run says. */
  public SenderRun again() {
    return new SenderRun(name, Math.max(run + 1, System.currentTimeMillis()));
  }

  /** The same run for another receiver. */
  public SenderRun beside() {
    return new SenderRun(name, run);
  }

  public BodyDatagram next(DatagramKind kind, String to, Optional<BodyElement> body) {
    return new BodyDatagram(kind, name, run, sequence.incrementAndGet(), System.currentTimeMillis() * 1_000_000, to,
        body);
  }
}
