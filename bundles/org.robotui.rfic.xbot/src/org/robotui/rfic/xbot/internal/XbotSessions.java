package org.robotui.rfic.xbot.internal;

import java.io.IOException;
import java.time.Duration;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.api.session.RobotSession;
import org.robotui.api.session.SessionFactory;
import org.robotui.api.session.SessionRfic;
import org.robotui.api.session.SessionScope;
import org.robotui.xbot.RtClient;

/** Sessions with a control of this machine. Each is attached to it, reads it at a rate, and ends with it. */
record XbotSessions(RficContext context, XbotSettings settings) implements SessionFactory {
  private static final Duration RETRY = Duration.ofSeconds(1);

  static Rfic rfic(RficContext context, XbotSettings settings) {
    return new SessionRfic(context, "the real-time control of " + settings.robot(), RETRY,
        new XbotSessions(context, settings));
  }

  @Override
  public RobotSession open(SessionScope scope) throws IOException {
    return new XbotSession(context, settings, scope.closing(RtClient.connect(settings.robot()), RtClient::close));
  }
}
