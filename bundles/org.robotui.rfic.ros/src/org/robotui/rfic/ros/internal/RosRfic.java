package org.robotui.rfic.ros.internal;

import java.io.IOException;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BooleanSupplier;
import java.util.function.UnaryOperator;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.api.RficWorker;
import org.robotui.api.link.LinkState;
import org.robotui.guard.Guard;
import org.robotui.guard.Guards;
import org.robotui.rfic.ros.internal.graph.Session;
import org.robotui.rfic.ros.internal.graph.SharedMasters;
import org.robotui.ros.NodeOptions;
import org.robotui.ros.message.MessageRegistry;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A ROS 1 robot. One thread of its own opens the node, follows the graph, and begins anew when the node was ended from
 * outside (as by {@code rosnode kill}).
 */
final class RosRfic implements Rfic {
  private static final Logger LOG = LoggerFactory.getLogger(RosRfic.class);
  private static final Duration RETRY = Duration.ofSeconds(3);
  private static final Duration END = Duration.ofMillis(1500);

  private final RficContext context;
  private final RosSettings settings;
  private final SharedMasters masters;
  private final Guards guards;
  private final RficWorker worker;
  private final Tidying tidying;
  private final AtomicReference<Session> session = new AtomicReference<>();
  private Optional<MessageRegistry> registry = Optional.empty(); // only on the worker

  RosRfic(RficContext context, RosSettings settings, SharedMasters masters, Guards guards) {
    this.context = context;
    this.settings = settings;
    this.masters = masters;
    this.guards = guards;
    this.worker = new RficWorker(context, RETRY, this::follow);
    this.tidying = new Tidying(context, masters.sweep());
  }

  @Override
  public void start() {
    worker.start(settings.master().toString());
    tidying.start();
  }

  private String follow(BooleanSupplier over) throws InterruptedException {
    MessageRegistry types = registry.orElseGet(MessageRegistry::fromEnvironment);
    registry = Optional.of(types);
    try {
      return settings.guard() ? guarded(types, over) : follow(types, UnaryOperator.identity(), over);
    } catch (IOException e) {
      return "no node can be opened here: " + e.getMessage();
    }
  }

  private String guarded(MessageRegistry types, BooleanSupplier over) throws IOException, InterruptedException {
    try (Guard guard = guards.open()) {
      return follow(types, options -> options.withCare(guard.sockets(), (to, words) -> guard.farewell(to, words)::close), over);
    }
  }

  private String follow(MessageRegistry types, UnaryOperator<NodeOptions> care, BooleanSupplier over) throws IOException, InterruptedException {
    try (Session opened = new Session(context, settings, types, masters, care)) {
      session.set(opened);
      return opened.follow(over);
    }
  }

  @Override
  public void close() {
    worker.stop();
    tidying.stop();
    Session opened = session.get();
    if (opened != null) {
      opened.close();
    }
    if (!worker.join(END)) {
      LOG.warn("{} did not end in {} ms", context.instance(), END.toMillis());
    }
    tidying.close();
    context.link().report(new LinkState.Disconnected());
  }
}
