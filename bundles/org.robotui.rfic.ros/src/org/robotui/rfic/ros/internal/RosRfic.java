package org.robotui.rfic.ros.internal;

import java.io.IOException;
import java.time.Duration;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.api.session.RobotSession;
import org.robotui.api.session.SessionRfic;
import org.robotui.api.session.SessionScope;
import org.robotui.guard.Guard;
import org.robotui.guard.Guards;
import org.robotui.message.MessageRegistry;
import org.robotui.rfic.ros.internal.graph.RosSession;
import org.robotui.rfic.ros.internal.graph.SharedMasters;
import org.robotui.ros.NodeOptions;

/**
 * A ROS 1 robot. A session is a node that follows the graph; the next one is opened when the node was ended from
 * outside (as by {@code rosnode kill}). Beside it, what earlier runs left at the masters is tidied up.
 */
final class RosRfic implements Rfic {
  private static final Duration RETRY = Duration.ofSeconds(3);

  private final RficContext context;
  private final RosSettings settings;
  private final SharedMasters masters;
  private final Guards guards;
  private final SessionRfic sessions;
  private final RepeatedCleanup tidying;
  private Optional<MessageRegistry> registry = Optional.empty(); // only on the thread of the sessions

  RosRfic(RficContext context, RosSettings settings, SharedMasters masters, Guards guards) {
    this.context = context;
    this.settings = settings;
    this.masters = masters;
    this.guards = guards;
    this.sessions = new SessionRfic(context, settings.master().toString(), RETRY, this::open);
    this.tidying = new RepeatedCleanup(context, masters.sweep());
  }

  @Override
  public void start() {
    sessions.start();
    tidying.start();
  }

  private RobotSession open(SessionScope scope) throws IOException {
    MessageRegistry types = registry.orElseGet(MessageRegistry::fromEnvironment);
    registry = Optional.of(types);
    try {
      return new RosSession(context, settings, types, masters,
          settings.guard() ? guarded(scope) : UnaryOperator.identity());
    } catch (IOException e) {
      throw new IOException("no node can be opened here: " + e.getMessage(), e);
    }
  }

  private UnaryOperator<NodeOptions> guarded(SessionScope scope) throws IOException {
    Guard guard = scope.closing(guards.open(), Guard::close);
    return options -> options.withCare(guard.sockets(), (to, words) -> guard.farewell(to, words)::close);
  }

  @Override
  public void close() {
    tidying.stop();
    sessions.close();
    tidying.close();
  }
}
