package org.robotui.gazebo.internal;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.HashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.robotui.gazebo.GazeboResponder;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.zeromq.ZMQ;

/** Services of ours. What others ask is answered on the thread of the loop. */
final class Services {
  private static final Logger LOG = LoggerFactory.getLogger(Services.class);
  private static final int PARTS = 9;
  private static final int MOST_ASKERS = 200;
  private static final long PATIENCE = Duration.ofSeconds(3).toNanos();

  private final NodeSockets sockets;
  private final PendingSends pending;
  private final Map<Form, GazeboResponder> responders = new ConcurrentHashMap<>();
  private final Set<String> askers = new HashSet<>();

  /** What is asked by a name, and the types of it. */
  record Form(String service, String request, String response) {
    boolean isOneWay() {
      return response.endsWith(".msgs.Empty");
    }
  }

  Services(NodeSockets sockets, PendingSends pending) {
    this.sockets = sockets;
    this.pending = pending;
  }

  void add(Form form, GazeboResponder responder) {
    responders.put(form, responder);
  }

  void remove(Form form) {
    responders.remove(form);
  }

  void take(ZMQ.Socket replier) {
    for (Optional<Frames> frames = Frames.receive(replier); frames.isPresent(); frames = Frames.receive(replier)) {
      frames.filter(all -> all.size() >= PARTS).ifPresent(this::asked);
    }
  }

  private void asked(Frames all) {
    Form form = new Form(all.text(1), all.text(7), all.text(8));
    Optional.ofNullable(responders.get(form)).ifPresent(responder -> {
      Optional<byte[]> answer = answer(responder, all.parts().get(6));
      String asker = all.text(2);
      boolean known = PeerAddress.isGood(asker)
          && (askers.contains(asker) || askers.size() < MOST_ASKERS && askers.add(asker));
      if (!form.isOneWay() && known) {
        Frames response = Frames.of(all.parts().get(3), all.parts().get(1), all.parts().get(4), all.parts().get(5),
            answer.orElse(new byte[0]), answer.isPresent() ? "1" : "0");
        pending.send(() -> sockets.answer(asker, response), System.nanoTime() + PATIENCE);
      }
    });
  }

  private static Optional<byte[]> answer(GazeboResponder responder, byte[] request) {
    try {
      return responder.answer(ByteBuffer.wrap(request));
    } catch (RuntimeException e) {
      LOG.warn("a service of ours failed: {}", e.toString());
      return Optional.empty();
    }
  }
}
