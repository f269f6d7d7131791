package org.robotui.rfic.ros.internal;

import java.io.IOException;
import java.time.Duration;
import java.util.concurrent.atomic.AtomicReference;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.api.link.LinkState;
import org.robotui.rfic.ros.internal.graph.Session;
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
  private final Thread worker;
  private final AtomicReference<Session> session = new AtomicReference<>();
  private volatile boolean closed;

  RosRfic(RficContext context, RosSettings settings) {
    this.context = context;
    this.settings = settings;
    this.worker = context.threads().newThread(this::run);
  }

  @Override
  public void start() {
    context.link().report(new LinkState.Connecting(settings.master().toString()));
    worker.start();
  }

  private void run() {
    MessageRegistry registry = MessageRegistry.fromEnvironment();
    while (!closed) {
      try (Session opened = new Session(context, settings, registry)) {
        session.set(opened);
        context.link().report(new LinkState.Failed(opened.follow(() -> closed), RETRY));
      } catch (IOException e) {
        context.link().report(new LinkState.Failed("no node can be opened here: " + e.getMessage(), RETRY));
      } catch (InterruptedException e) {
        LOG.debug("{} ends", context.instance());
        return;
      }
      pause();
    }
  }

  private void pause() {
    try {
      Thread.sleep(RETRY);
    } catch (InterruptedException e) {
      closed = true;
    }
  }

  @Override
  public void close() {
    closed = true;
    worker.interrupt();
    Session opened = session.get();
    if (opened != null) {
      opened.close();
    }
    join();
    context.link().report(new LinkState.Disconnected());
  }

  private void join() {
    try {
      if (worker.isAlive() && !worker.join(END)) {
        LOG.warn("{} did not end in {} ms", context.instance(), END.toMillis());
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
