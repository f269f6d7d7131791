package org.robotui.rfic.player.internal;

import java.io.IOException;
import java.time.Duration;
import javax.net.SocketFactory;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.api.session.RobotSession;
import org.robotui.api.session.SessionFactory;
import org.robotui.api.session.SessionRfic;
import org.robotui.api.session.SessionScope;
import org.robotui.guard.Guard;
import org.robotui.guard.Guards;
import org.robotui.rfic.player.internal.link.PlayerSession;

/**
 * Sessions with a robot behind a Player server. A session lasts as long as the robot interface; its client reconnects
 * by itself.
 */
record PlayerSessions(RficContext context, PlayerSettings settings, Guards guards) implements SessionFactory {
  private static final Duration RETRY = Duration.ofSeconds(3);

  static Rfic rfic(RficContext context, PlayerSettings settings, Guards guards) {
    return new SessionRfic(context, settings.peer(), RETRY, new PlayerSessions(context, settings, guards));
  }

  @Override
  public RobotSession open(SessionScope scope) throws IOException {
    SocketFactory sockets =
        settings.guard() ? scope.closing(guards.open(), Guard::close).sockets() : SocketFactory.getDefault();
    return new PlayerSession(context, settings, sockets);
  }
}
