package org.robotui.gazebo.internal;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.Optional;
import org.robotui.gazebo.OfferedService;
import org.robotui.net.call.Outcome;
import org.robotui.web.OpenQuestions;
import org.zeromq.ZMQ;

/** Requests of ours and their responses. Asking is safe for all threads. */
final class Requests {
  private static final int PARTS = 6;
  private static final String DONE = "1";

  private final SocketLoop loop;
  private final NodeSockets sockets;
  private final PendingSends pending;
  private final String node;
  private final OpenQuestions<ByteBuffer> open = new OpenQuestions<>();

  Requests(SocketLoop loop, NodeSockets sockets, PendingSends pending, String node) {
    this.loop = loop;
    this.sockets = sockets;
    this.pending = pending;
    this.node = node;
  }

  Outcome<ByteBuffer> ask(OfferedService service, byte[] request, Duration patience) throws InterruptedException {
    if (!PeerAddress.isGood(service.address())) {
      return new Outcome.Failed<>(service.name().name() + " has an address that cannot be asked: " + service.address());
    }
    long deadline = System.nanoTime() + patience.toNanos();
    return open.ask(service.name().name(), patience, id -> loop.leave(() -> send(service, request, id, deadline)));
  }

  private void send(OfferedService service, byte[] request, int id, long deadline) {
    Frames frames =
        Frames.of(service.socket(), service.name().text(), sockets.ends().responses(), sockets.ends().responsesId(),
            node, id, request, service.request(), service.response());
    boolean waits = pending.send(() -> sent(service, frames, id), deadline);
    if (!waits) {
      open.answered(String.valueOf(id), new Outcome.Failed<>("too many requests wait for their connections"));
    }
  }

  private boolean sent(OfferedService service, Frames frames, int id) {
    boolean sent = sockets.ask(service.address(), frames);
    if (sent && service.isOneWay()) {
      open.answered(String.valueOf(id), new Outcome.Done<>(ByteBuffer.allocate(0)));
    }
    return sent;
  }

  /** Takes the responses that have come. On the thread of the loop. */
  void take(ZMQ.Socket responses) {
    for (Optional<Frames> frames = Frames.receive(responses); frames.isPresent(); frames = Frames.receive(responses)) {
      frames.filter(all -> all.size() >= PARTS && all.text(2).equals(node)).ifPresent(all -> open.answered(all.text(3),
          all.text(5).equals(DONE) ? new Outcome.Done<>(ByteBuffer.wrap(all.parts().get(4)))
              : new Outcome.Refused<>("the service says that it failed")));
    }
  }

  void end(String reason) {
    open.end(reason);
  }
}
