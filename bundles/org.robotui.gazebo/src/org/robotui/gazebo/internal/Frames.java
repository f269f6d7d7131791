package org.robotui.gazebo.internal;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.zeromq.ZMQ;

/**
 * The parts of a message of ZeroMQ.
 *
 * @param parts each of them
 */
record Frames(List<byte[]> parts) {
  private static final int MOST = 16;

  /** What has come, all parts of it; none where nothing has. Parts that no message of the protocol has are dropped. */
  static Optional<Frames> receive(ZMQ.Socket socket) {
    byte[] part = socket.recv(ZMQ.DONTWAIT);
    if (part == null) {
      return Optional.empty();
    }
    List<byte[]> parts = new ArrayList<>(List.of(part));
    while (socket.hasReceiveMore()) {
      byte[] next = socket.recv(ZMQ.DONTWAIT);
      if (next != null && parts.size() < MOST) {
        parts.add(next);
      }
    }
    return Optional.of(new Frames(parts));
  }

  /** Of texts and bytes. */
  static Frames of(Object... parts) {
    List<byte[]> all = new ArrayList<>();
    for (Object part : parts) {
      all.add(part instanceof byte[] bytes ? bytes : part.toString().getBytes(StandardCharsets.UTF_8));
    }
    return new Frames(all);
  }

  /** Hands all of it to a socket; answers whether it took it. */
  boolean send(ZMQ.Socket socket) {
    for (int i = 0; i < parts.size(); i++) {
      int more = i + 1 < parts.size() ? ZMQ.SNDMORE : 0;
      if (!socket.send(parts.get(i), more | ZMQ.DONTWAIT)) {
        return false;
      }
    }
    return true;
  }

  int size() {
    return parts.size();
  }

  String text(int i) {
    return new String(parts.get(i), StandardCharsets.UTF_8);
  }
}
