package org.robotui.api.host;

import java.util.concurrent.CompletionStage;
import org.robotui.api.port.SourceId;

/**
 * A robot interface that is tried beside the one whose place it shall take. It connects to its robot and says what that
 * has, but nothing is wired to it and it is never commanded. Closing it ends the trial; what runs is not touched. Safe
 * for all threads.
 */
public interface Exchange extends AutoCloseable {
  /**
   * What would become of every connection, as far as is known now. It changes while the robot is looked at.
   *
   * @return a preview; cheap enough to ask for ten times a second
   */
  ExchangePreview preview();

  /**
   * Says where to connect a port of a view after the exchange.
   *
   * @param port the view's port
   * @param peer a port of a robot interface that fits
   */
  void choose(SourceId port, SourceId peer);

  /**
   * Exchanges: what we drive is stopped and leases are given back, the old interface ends, streams, frames and the
   * clock are reset, and the new one starts in its place. Views and other interfaces go on. Where the new one cannot be
   * started, the old one is started again. Afterwards the trial has ended, unless it was refused.
   *
   * @param goWithout true to do it also where used connections would be lost or the robot has not answered yet
   * @return completes when it is done, and says what came of it
   */
  CompletionStage<ExchangeOutcome> apply(boolean goWithout);

  @Override
  void close();
}
