package org.robotui.core.internal.port;

import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Function;
import org.robotui.api.command.Principal;
import org.robotui.api.host.PortStatus;
import org.robotui.api.port.BrowsePort;
import org.robotui.api.port.Browser;
import org.robotui.api.port.SourceId;
import org.robotui.core.internal.time.NanoClock;

/** A way to browse a robot, as offered. */
public final class BrowseTarget implements Offered {
  private final SourceId id;
  private final BrowsePort port;
  private final Function<Principal, Browser> browser;
  private final Withdrawal withdrawal;
  private final AtomicBoolean closed = new AtomicBoolean();

  /** Made by the table of offers. */
  public BrowseTarget(SourceId id, BrowsePort port, Function<Principal, Browser> browser, Withdrawal withdrawal) {
    this.id = id;
    this.port = port;
    this.browser = browser;
    this.withdrawal = withdrawal;
  }

  /** Who answers somebody, as far as that one may ask. */
  public Browser browserFor(Principal principal) {
    return browser.apply(principal);
  }

  @Override
  public SourceId id() {
    return id;
  }

  @Override
  public BrowsePort port() {
    return port;
  }

  @Override
  public PortStatus status(NanoClock clock) {
    return new PortStatus(id, port.kind(), port.typeName(), false, 0, 0, Double.NaN, false, 0, "", "");
  }

  @Override
  public void close() {
    if (closed.compareAndSet(false, true)) {
      withdrawal.withdrawn(this);
    }
  }
}
