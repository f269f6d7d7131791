package org.robotui.rfic.lcm.internal;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import javax.net.SocketFactory;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.api.session.RobotSession;
import org.robotui.api.session.SessionFactory;
import org.robotui.api.session.SessionRfic;
import org.robotui.api.session.SessionScope;
import org.robotui.guard.Guard;
import org.robotui.guard.Guards;
import org.robotui.lcm.type.TypeFolder;
import org.robotui.rfic.lcm.internal.session.LcmSession;

/** Sessions with robots that speak LCM at one URL. Each reads the types, and ends when their files have changed. */
record LcmSessions(RficContext context, LcmSettings settings, Guards guards) implements SessionFactory {
  private static final Duration RETRY = Duration.ofSeconds(3);

  static Rfic rfic(RficContext context, LcmSettings settings, Guards guards) {
    return new SessionRfic(context, settings.url().toString(), RETRY, new LcmSessions(context, settings, guards));
  }

  @Override
  public RobotSession open(SessionScope scope) throws IOException {
    SocketFactory sockets =
        settings.guard() ? scope.closing(guards.open(), Guard::close).sockets() : SocketFactory.getDefault();
    // a recording would begin anew, or be written over
    TypeFiles files = new TypeFiles(settings.url().provider().equals("file") ? List.of() : settings.types());
    files.reading(System.nanoTime());
    return new LcmSession(context, settings, TypeFolder.read(settings.types()), sockets,
        () -> files.changed(System.nanoTime()));
  }
}
