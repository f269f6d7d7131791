package org.robotui.ros.internal.master;

import java.io.IOException;
import java.time.Duration;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.net.collection.LruMap;
import org.robotui.net.socket.CloseableSet;
import org.robotui.net.socket.HostPort;
import org.robotui.net.thread.Workers;
import org.robotui.ros.XmlRpcValue;
import org.robotui.ros.internal.xmlrpc.XmlRpcClient;
import org.robotui.ros.internal.xmlrpc.XmlRpcFault;
import org.robotui.ros.internal.xmlrpc.XmlRpcLimits;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Calls nodes back. Each node has a queue; of several updates of one topic or parameter that wait only the newest is
 * sent. Threads are few, however many nodes there are. A node that hangs holds one of them until the time-out, and from
 * then on only one of those that are for nodes that have not answered yet: nodes that answer wait for no other.
 */
final class Notifier {

  /** Threads for nodes that answered the last time. */
  static final int PROVEN_THREADS = 16;
  /** Threads for all others. */
  static final int OTHER_THREADS = 32;

  private static final Logger LOG = LoggerFactory.getLogger(Notifier.class);
  private static final int MOST_PROVEN = 4_096;
  /** For nodes that have not answered yet: so many of them can hang that none may take long. */
  private static final Duration OTHER_TIMEOUT = Duration.ofSeconds(2);

  /** What a node is to be told, and what makes a newer message replace an older one. */
  record Message(String method, String subject, List<XmlRpcValue> arguments) {

    String key() {
      return method + " " + subject;
    }
  }

  private final Lane provenLane;
  private final Lane otherLane;
  private final CloseableSet open = new CloseableSet();
  private final Map<String, Map<String, Message>> waiting = new HashMap<>();
  private final Map<String, Boolean> proven = new LruMap<>(MOST_PROVEN);

  Notifier(Workers workers) {
    provenLane = new Lane(workers, "ros master to nodes", PROVEN_THREADS);
    otherLane = new Lane(workers, "ros master to new nodes", OTHER_THREADS);
  }

  void publisherUpdate(String uri, String topic, List<String> publishers) {
    send(uri, new Message("publisherUpdate", topic,
        List.of(XmlRpcValue.of("/master"), XmlRpcValue.of(topic), XmlRpcValue.ofTexts(publishers))));
  }

  void paramUpdate(String uri, String key, XmlRpcValue value) {
    send(uri, new Message("paramUpdate", key, List.of(XmlRpcValue.of("/master"), XmlRpcValue.of(key), value)));
  }

  void shutdown(String uri, String reason) {
    send(uri, new Message("shutdown", "", List.of(XmlRpcValue.of("/master"), XmlRpcValue.of(reason))));
  }

  private synchronized void send(String uri, Message message) {
    Optional<Map<String, Message>> queue = Optional.ofNullable(waiting.get(uri));
    queue.ifPresentOrElse(known -> replace(known, message), () -> {
      Map<String, Message> fresh = new LinkedHashMap<>();
      replace(fresh, message);
      waiting.put(uri, fresh);
      enqueue(uri);
    });
  }

  /** A newer message goes to the end: parameters of one namespace must not overtake each other. */
  private static void replace(Map<String, Message> queue, Message message) {
    queue.remove(message.key());
    queue.put(message.key(), message);
  }

  private void enqueue(String uri) {
    boolean answers = proven.containsKey(uri);
    (answers ? provenLane : otherLane).execute(() -> drain(uri, answers));
  }

  /** Tells a node what waits for it, as long as it answers as well as its lane demands. */
  private void drain(String uri, boolean answers) {
    XmlRpcLimits limits = answers ? XmlRpcLimits.standard() : XmlRpcLimits.standard().withMessage(OTHER_TIMEOUT);
    try (XmlRpcClient client = new XmlRpcClient(HostPort.ofUri(uri, "http"), limits)) {
      open.add(client);
      boolean stays = true;
      for (Optional<Message> next = poll(uri); next.isPresent(); next = stays ? poll(uri) : Optional.empty()) {
        stays = call(client, next.get()) == answers;
      }
      open.forget(client);
      if (!stays) {
        change(uri, !answers);
      }
    } catch (IllegalArgumentException e) {
      LOG.warn("cannot tell a node anything: {}", e.getMessage());
      forget(uri);
    }
  }

  /** What still waits for the node waits in the other lane now. */
  private synchronized void change(String uri, boolean answers) {
    if (answers) {
      proven.put(uri, true);
    } else {
      proven.remove(uri);
    }
    if (waiting.get(uri).isEmpty()) {
      waiting.remove(uri);
    } else {
      enqueue(uri);
    }
  }

  private synchronized Optional<Message> poll(String uri) {
    Map<String, Message> queue = waiting.get(uri);
    Optional<Message> next = queue.values().stream().findFirst();
    next.ifPresentOrElse(message -> queue.remove(message.key()), () -> waiting.remove(uri));
    return next;
  }

  private synchronized void forget(String uri) {
    waiting.remove(uri);
  }

  /** Whether it answered. */
  private static boolean call(XmlRpcClient client, Message message) {
    try {
      client.call(message.method(), message.arguments());
      return true;
    } catch (XmlRpcFault e) {
      LOG.debug("{} of {} was refused by {}: {}", message.method(), message.subject(), client.target(), e.getMessage());
      return true;
    } catch (IOException e) {
      LOG.debug("{} of {} did not reach {}: {}", message.method(), message.subject(), client.target(), e.getMessage());
      return false;
    }
  }

  void close() {
    provenLane.clear();
    otherLane.clear();
    open.close();
  }
}
