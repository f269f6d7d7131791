package org.robotui.rfic.yarp.internal;

import java.io.IOException;
import java.net.InetAddress;
import java.time.Duration;
import javax.net.SocketFactory;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.api.session.RobotSession;
import org.robotui.api.session.SessionFactory;
import org.robotui.api.session.SessionRfic;
import org.robotui.api.session.SessionScope;
import org.robotui.yarp.name.NameClient;
import org.robotui.yarp.port.PortOptions;

/** Sessions with a name server and the ports that it knows; each has one port of its own. */
record YarpSessions(RficContext context, YarpSettings settings) implements SessionFactory {
  private static final Duration RETRY = Duration.ofSeconds(1);
  /** Twice as long is shorter than the two seconds in which a robot interface has to end: asking is not interrupted. */
  private static final Duration ANSWER = Duration.ofMillis(700);

  static Rfic rfic(RficContext context, YarpSettings settings) {
    return new SessionRfic(context, settings.peer(), RETRY, new YarpSessions(context, settings));
  }

  @Override
  public RobotSession open(SessionScope scope) throws IOException {
    NameClient names = new NameClient(settings.server(), SocketFactory.getDefault(), ANSWER);
    try {
      InetAddress near = names.near();
      names.list();
      return new YarpSession(context, settings, names, near,
          new PortOptions(context.threads(), SocketFactory.getDefault(), ANSWER));
    } catch (IOException e) {
      throw new IOException(e.getMessage()
          + "; is yarpserver running there? Correct host and port, or YARP_NAMESERVER, where it is elsewhere", e);
    }
  }
}
