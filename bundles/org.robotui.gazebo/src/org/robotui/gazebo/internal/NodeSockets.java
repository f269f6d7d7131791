package org.robotui.gazebo.internal;

import java.io.IOException;
import java.net.InetAddress;
import java.nio.charset.StandardCharsets;
import java.util.HashSet;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ThreadFactory;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.zeromq.SocketType;
import org.zeromq.ZMQ;
import org.zeromq.ZMQException;

/**
 * The sockets of a node: what is published and received, what is asked and answered. All but the addresses is for the
 * thread of the loop alone.
 */
final class NodeSockets {
  private static final Logger LOG = LoggerFactory.getLogger(NodeSockets.class);

  /** Longer messages end the connection that they come by. */
  static final int LONGEST = 1 << 25;

  private static final int MOST_RECEIVED = 16;
  private static final int MOST_SENT = 100;
  private static final int MOST_FILTERS = 10_000;
  /** JeroMQ 0.6.0 sometimes does not read what comes first by a connection that it makes: it then makes another. */
  private static final int HANDSHAKE_MILLIS = 500;
  private static final int RETRY_MILLIS = 100;
  private static final int SLOWEST_MILLIS = 2000;
  private static final int LINGER_MILLIS = 300;

  private final ZMQ.Context context;
  private final ZMQ.Socket publisher;
  private final ZMQ.Socket subscriber;
  private final ZMQ.Socket requester;
  private final ZMQ.Socket responses;
  private final ZMQ.Socket replier;
  private final Ends ends;
  private final Set<String> filters = ConcurrentHashMap.newKeySet();
  private final Set<String> heard = new HashSet<>();
  private final Set<String> asked = new HashSet<>();
  private final Set<String> answered = new HashSet<>();

  /** Addresses and identities of sockets. */
  record Ends(String publishing, String responses, String responsesId, String replier, String replierId) {}

  NodeSockets(InetAddress address, String process, ThreadFactory threads) throws IOException {
    this.context = ZMQ.context(1);
    context.setThreadFactor((work, name) -> {
      Thread thread = threads.newThread(work);
      thread.setName("gazebo " + name);
      return thread;
    });
    context.setUncaughtExceptionHandler((thread, e) -> LOG.warn("{} ended by an error", thread.getName(), e));
    context.setNotificationExceptionHandler((thread, e) -> LOG.warn("{}: {}", thread.getName(), e.toString(), e));
    this.publisher = socket(SocketType.XPUB);
    this.subscriber = socket(SocketType.SUB);
    this.requester = socket(SocketType.ROUTER);
    this.responses = socket(SocketType.ROUTER);
    this.replier = socket(SocketType.ROUTER);
    publisher.setLinger(LINGER_MILLIS);
    requester.setRouterMandatory(true);
    replier.setRouterMandatory(true);
    Frames identities = Frames.of(process + ".responses", process + ".requests");
    responses.setIdentity(identities.parts().getFirst());
    replier.setIdentity(identities.parts().getLast());
    try {
      for (ZMQ.Socket each : new ZMQ.Socket[]{publisher, responses, replier}) {
        each.bind("tcp://" + address.getHostAddress() + ":*");
      }
      this.ends = new Ends(publisher.getLastEndpoint(), responses.getLastEndpoint(), identities.text(0),
          replier.getLastEndpoint(), identities.text(1));
    } catch (ZMQException e) {
      close();
      throw new IOException("cannot listen at " + address.getHostAddress() + ": " + e.getMessage(), e);
    }
  }

  private ZMQ.Socket socket(SocketType type) {
    ZMQ.Socket socket = context.socket(type);
    socket.setMaxMsgSize(LONGEST);
    socket.setRcvHWM(MOST_RECEIVED);
    socket.setSndHWM(MOST_SENT);
    socket.setLinger(0);
    socket.setHandshakeIvl(HANDSHAKE_MILLIS);
    socket.setReconnectIVL(RETRY_MILLIS);
    socket.setReconnectIVLMax(SLOWEST_MILLIS);
    return socket;
  }

  /** Where we publish, and where and as what we are asked and answered: known from the begin, for any thread. */
  Ends ends() {
    return ends;
  }

  ZMQ.Poller poller() {
    ZMQ.Poller poller = context.poller(4);
    poller.register(subscriber, ZMQ.Poller.POLLIN);
    poller.register(responses, ZMQ.Poller.POLLIN);
    poller.register(replier, ZMQ.Poller.POLLIN);
    poller.register(publisher, ZMQ.Poller.POLLIN);
    return poller;
  }

  /** Takes note of who has connected to what is published, which comes some time after he says so by discovery. */
  void takeFilters() {
    for (Optional<Frames> frames = Frames.receive(publisher); frames.isPresent(); frames = Frames.receive(publisher)) {
      byte[] said = frames.get().parts().getFirst();
      if (said.length > 1) {
        String topic = new String(said, 1, said.length - 1, StandardCharsets.UTF_8);
        if (said[0] == 0) {
          filters.remove(topic);
        } else if (filters.size() < MOST_FILTERS) {
          filters.add(topic);
        }
      }
    }
  }

  /** Whether messages of a topic are sent to anybody; for any thread. */
  boolean isHeard(String topic) {
    return filters.contains(topic);
  }

  ZMQ.Socket subscriber() {
    return subscriber;
  }

  ZMQ.Socket responses() {
    return responses;
  }

  ZMQ.Socket replier() {
    return replier;
  }

  void hear(String address) {
    connect(subscriber, heard, address);
  }

  void ignore(String address) {
    disconnect(subscriber, heard, address);
  }

  void filter(String topic, boolean wanted) {
    if (wanted) {
      subscriber.subscribe(topic);
    } else {
      subscriber.unsubscribe(topic);
    }
  }

  boolean publish(Frames message) {
    return message.send(publisher);
  }

  /** Asks; answers whether the one who is asked is connected by now. */
  boolean ask(String address, Frames request) {
    connect(requester, asked, address);
    return reach(requester, request);
  }

  void askNoMore(String address) {
    disconnect(requester, asked, address);
  }

  boolean answer(String address, Frames response) {
    connect(replier, answered, address);
    return reach(replier, response);
  }

  void answerNoMore(String address) {
    disconnect(replier, answered, address);
  }

  private static void connect(ZMQ.Socket socket, Set<String> connected, String address) {
    if (connected.add(address)) {
      try {
        socket.connect(address);
      } catch (RuntimeException e) {
        connected.remove(address);
        throw e;
      }
    }
  }

  private static void disconnect(ZMQ.Socket socket, Set<String> connected, String address) {
    if (connected.remove(address)) {
      socket.disconnect(address);
    }
  }

  private static boolean reach(ZMQ.Socket socket, Frames message) {
    try {
      return message.send(socket);
    } catch (ZMQException e) {
      if (e.getErrorCode() == ZMQ.Error.EHOSTUNREACH.getCode()) {
        return false;
      }
      throw e;
    }
  }

  void close() {
    for (ZMQ.Socket each : new ZMQ.Socket[]{subscriber, requester, responses, replier, publisher}) {
      each.close();
    }
    context.term();
  }
}
