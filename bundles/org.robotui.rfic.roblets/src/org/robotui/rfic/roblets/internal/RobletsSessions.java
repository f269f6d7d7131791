package org.robotui.rfic.roblets.internal;

import java.io.IOException;
import java.time.Duration;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.api.session.RobotSession;
import org.robotui.api.session.SessionFactory;
import org.robotui.api.session.SessionRfic;
import org.robotui.api.session.SessionScope;

/** Sessions with a brain, one after another; each is one watcher of it. */
record RobletsSessions(RficContext context, RobletsSettings settings) implements SessionFactory {
  private static final Duration RETRY = Duration.ofSeconds(1);

  static Rfic rfic(RficContext context, RobletsSettings settings) {
    return new SessionRfic(context, settings.peer(), RETRY, new RobletsSessions(context, settings));
  }

  @Override
  public RobotSession open(SessionScope scope) throws IOException {
    return new RobletsSession(context, settings);
  }
}
