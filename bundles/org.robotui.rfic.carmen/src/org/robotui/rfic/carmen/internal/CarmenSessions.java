package org.robotui.rfic.carmen.internal;

import java.io.IOException;
import java.time.Duration;
import javax.net.SocketFactory;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.api.session.RobotSession;
import org.robotui.api.session.SessionFactory;
import org.robotui.api.session.SessionRfic;
import org.robotui.api.session.SessionScope;
import org.robotui.carmen.message.IpcForms;
import org.robotui.carmen.module.IpcModule;
import org.robotui.carmen.module.ModuleOptions;
import org.robotui.guard.Guard;
import org.robotui.guard.Guards;

/** Sessions with a central; each is one module. */
record CarmenSessions(RficContext context, CarmenSettings settings, Guards guards) implements SessionFactory {
  private static final Duration RETRY = Duration.ofSeconds(2);
  /** Shorter than the two seconds in which a robot interface has to end: connecting cannot be interrupted. */
  private static final Duration ANSWER = Duration.ofMillis(1500);

  static Rfic rfic(RficContext context, CarmenSettings settings, Guards guards) {
    return new SessionRfic(context, settings.peer(), RETRY, new CarmenSessions(context, settings, guards));
  }

  @Override
  public RobotSession open(SessionScope scope) throws IOException {
    SocketFactory sockets =
        settings.guard() ? scope.closing(guards.open(), Guard::close).sockets() : SocketFactory.getDefault();
    IpcForms forms = IpcForms.carmen();
    try {
      IpcModule module = IpcModule.connect(settings.central(), forms,
          new ModuleOptions("robotui", context.threads(), sockets, ANSWER));
      return new CarmenSession(context, settings, module, forms);
    } catch (IOException e) {
      throw new IOException(Advice.with(e.getMessage()), e);
    }
  }
}
