package org.robotui.ros.internal.node;

import java.time.Duration;
import org.robotui.net.call.Backoff;
import org.robotui.net.log.PeerText;
import org.robotui.net.thread.Workers;
import org.robotui.ros.GraphName;
import org.robotui.ros.LinkEvent;
import org.robotui.ros.LinkState;
import org.robotui.ros.NodeOptions;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** What all parts of one node share. */
record NodeContext(GraphName name, NodeOptions options, Workers workers) {

  private static final Logger LOG = LoggerFactory.getLogger(NodeContext.class);

  void start(String task, Runnable work) {
    workers.start("ros " + name + " " + task, work);
  }

  Backoff backoff() {
    return new Backoff(options.minBackoff(), options.maxBackoff());
  }

  /** Tells the owner; what its listener throws must not end a link. */
  void report(LinkEvent.Kind kind, String topic, String peer, LinkState state) {
    try {
      options.links().onLink(new LinkEvent(kind, topic, PeerText.brief(peer), brief(state)));
    } catch (RuntimeException e) {
      LOG.error("link listener of {} failed", name, e);
    }
    if (state instanceof LinkState.Failed failed) {
      LOG.debug("{}: {}", name, PeerText.brief(failed.reason()));
    }
  }

  private static LinkState brief(LinkState state) {
    return switch (state) {
      case LinkState.Failed failed -> new LinkState.Failed(PeerText.brief(failed.reason()), failed.retryAfter());
      case LinkState.Closed closed -> new LinkState.Closed(PeerText.brief(closed.reason()));
      default -> state;
    };
  }

  Duration handshake() {
    return options.handshakeTimeout();
  }
}
