package org.robotui.rfic.ros2.internal;

import java.io.IOException;
import java.time.Duration;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.api.session.RobotSession;
import org.robotui.api.session.SessionFactory;
import org.robotui.api.session.SessionRfic;
import org.robotui.api.session.SessionScope;
import org.robotui.rfic.ros2.internal.graph.Ros2Session;
import org.robotui.rfic.ros2.internal.graph.SharedDomains;
import org.robotui.ros2.Ros2Context;
import org.robotui.ros2.Ros2Options;

/**
 * Takes part in the domain of a robot. One session lasts as long as its robot interface, whether the robot is there or
 * not: nobody can end it from outside.
 */
record Ros2Sessions(RficContext context, Ros2Settings settings, SharedDomains domains) implements SessionFactory {
  private static final Duration RETRY = Duration.ofSeconds(3);

  static Rfic rfic(RficContext context, Ros2Settings settings, SharedDomains domains) {
    return new SessionRfic(context, settings.peer(), RETRY, new Ros2Sessions(context, settings, domains));
  }

  @Override
  public RobotSession open(SessionScope scope) throws IOException {
    Ros2Options options = Ros2Options.standard(context.threads()).withDefinitions(settings.definitions());
    Ros2Context ros = scope.closing(domains.open(settings.environment(), options), Ros2Context::close);
    return new Ros2Session(context, settings, ros, domains.of(settings.environment()));
  }
}
