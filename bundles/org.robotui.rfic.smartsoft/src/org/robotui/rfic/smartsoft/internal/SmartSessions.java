package org.robotui.rfic.smartsoft.internal;

import java.io.IOException;
import java.nio.file.Path;
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
import org.robotui.rfic.smartsoft.internal.feed.NamingDirectory;
import org.robotui.smartsoft.object.CommTypes;
import org.robotui.smartsoft.wire.LinkOptions;

/** Sessions with a naming service and the components that it knows. */
record SmartSessions(RficContext context, SmartSettings settings, Guards guards) implements SessionFactory {
  private static final Duration RETRY = Duration.ofSeconds(2);
  /** Shorter than the two seconds in which a robot interface has to end: connecting cannot be interrupted. */
  private static final Duration ANSWER = Duration.ofMillis(1500);

  static Rfic rfic(RficContext context, SmartSettings settings, Guards guards) {
    return new SessionRfic(context, settings.peer(), RETRY, new SmartSessions(context, settings, guards));
  }

  @Override
  public RobotSession open(SessionScope scope) throws IOException {
    CommTypes types = types();
    SocketFactory sockets =
        settings.guard() ? scope.closing(guards.open(), Guard::close).sockets() : SocketFactory.getDefault();
    NamingDirectory directory = new NamingDirectory(settings.naming(), sockets, ANSWER);
    try {
      directory.list();
      return new SmartSession(context, settings, directory, types,
          new LinkOptions(context.threads(), sockets, ANSWER));
    } catch (IOException e) {
      directory.close();
      throw new IOException(SmartAdvice.with(e.getMessage()), e);
    }
  }

  private CommTypes types() throws IOException {
    CommTypes shipped = CommTypes.shipped();
    if (settings.objects().isEmpty()) {
      return shipped;
    }
    Path folder = settings.objects().get();
    try {
      return shipped.with(folder);
    } catch (IOException e) {
      throw new IOException("'objects': the folder " + folder + " cannot be read (" + e.getMessage()
          + "); write that in which your .idl files are", e);
    }
  }
}
