package org.robotui.rfic.foxglove.internal;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import org.robotui.testkit.web.WebCaller;
import org.robotui.testkit.web.WebServer;
import org.robotui.testkit.web.WebServerLink;
import org.robotui.web.tree.JsonText;
import org.robotui.web.tree.TreeException;
import org.robotui.web.tree.Trees;

/** A server that keeps the protocol, with the channels, services and parameters that it is given. */
final class FoxgloveServer implements WebCaller, AutoCloseable {
  private static final long SINCE = 1_700_000_000_000_000_000L;

  /** A subscription of a client. */
  record Subscription(WebServerLink link, long id, long channel) {}

  /** What a client published. */
  record Said(String topic, String encoding, String type, ByteBuffer payload) {}

  final List<Subscription> subscriptions = new CopyOnWriteArrayList<>();
  final Queue<Said> said = new ConcurrentLinkedQueue<>();
  final Map<String, Object> parameters = new ConcurrentHashMap<>();
  /** Channels of clients, by their numbers within their links. */
  final Map<String, Map<String, Object>> advertised = new ConcurrentHashMap<>();
  final List<String> heard = new CopyOnWriteArrayList<>();
  private final List<WebServerLink> links = new CopyOnWriteArrayList<>();
  private final Map<String, Object> info;
  private final List<Map<String, Object>> channels = new CopyOnWriteArrayList<>();
  private final List<Map<String, Object>> services = new ArrayList<>();
  private final WebServer server;

  FoxgloveServer(List<String> capabilities, List<String> encodings) throws IOException {
    info = Map.of("op", "serverInfo", "name", "robot", "capabilities", capabilities, "supportedEncodings", encodings);
    server = new WebServer(this);
  }

  int port() {
    return server.port();
  }

  void channel(long id, String topic, String encoding, String type, String schemaEncoding, String schema) {
    Map<String, Object> channel = new LinkedHashMap<>(Map.of("id", id, "topic", topic, "encoding", encoding,
        "schemaName", type, "schema", schema));
    channel.put("schemaEncoding", schemaEncoding);
    channels.add(channel);
    tell(Map.of("op", "advertise", "channels", List.of(channel)));
  }

  void withdraw(long id) {
    channels.removeIf(each -> each.get("id").equals(id));
    tell(Map.of("op", "unadvertise", "channelIds", List.of(id)));
  }

  void service(Map<String, Object> service) {
    services.add(service);
  }

  void tell(Map<String, Object> message) {
    links.forEach(link -> link.say(JsonText.write(message)));
  }

  void tell(byte[] bytes) {
    links.forEach(link -> link.say(bytes));
  }

  /** Says something to those who have subscribed to a channel. */
  void publish(long channel, ByteBuffer payload) {
    for (Subscription each : subscriptions) {
      if (each.channel() == channel) {
        ByteBuffer message = ByteBuffer.allocate(13 + payload.remaining()).order(ByteOrder.LITTLE_ENDIAN);
        each.link().say(message.put((byte) 1).putInt((int) each.id()).putLong(SINCE).put(payload.duplicate()).array());
      }
    }
  }

  int listeners(long channel) {
    return (int) subscriptions.stream().filter(each -> each.channel() == channel).count();
  }

  @Override
  public void opened(WebServerLink link) {
    link.say(JsonText.write(info));
    link.say(JsonText.write(Map.of("op", "advertise", "channels", channels)));
    link.say(JsonText.write(Map.of("op", "advertiseServices", "services", services)));
    links.add(link);
  }

  @Override
  public void closed(WebServerLink link) {
    links.remove(link);
    subscriptions.removeIf(each -> each.link() == link);
    advertised.keySet().removeIf(key -> key.startsWith(link.hashCode() + " "));
  }

  @Override
  public void text(WebServerLink link, String text) {
    try {
      Map<String, Object> message = Trees.object(JsonText.read(text));
      String op = Trees.text(message, "op");
      heard.add(op);
      answer(link, op, message);
    } catch (TreeException e) {
      throw new IllegalStateException(text, e);
    }
  }

  private void answer(WebServerLink link, String op, Map<String, Object> message) throws TreeException {
    switch (op) {
      case "subscribe" -> {
        for (Object each : Trees.list(message, "subscriptions")) {
          Map<String, Object> item = Trees.object(each);
          subscribe(new Subscription(link, Trees.whole(item, "id"), Trees.whole(item, "channelId")));
        }
      }
      case "unsubscribe" -> Trees.list(message, "subscriptionIds")
          .forEach(id -> subscriptions.removeIf(each -> each.link() == link && id.equals(each.id())));
      case "advertise" -> {
        for (Object each : Trees.list(message, "channels")) {
          Map<String, Object> item = Trees.object(each);
          advertised.put(link.hashCode() + " " + item.get("id"), item);
        }
      }
      case "unadvertise" -> Trees.list(message, "channelIds")
          .forEach(id -> advertised.remove(link.hashCode() + " " + id));
      case "getParameters" -> parameters(link, message);
      case "setParameters" -> {
        for (Object each : Trees.list(message, "parameters")) {
          Map<String, Object> item = Trees.object(each);
          parameters.put(Trees.text(item, "name"), item.get("value"));
        }
        parameters(link, message);
      }
      case "subscribeConnectionGraph" -> link.say(JsonText.write(Map.of("op", "connectionGraphUpdate",
          "publishedTopics", List.of(), "subscribedTopics",
          List.of(Map.of("name", "/cmd_vel", "subscriberIds", List.of("/base"))))));
      default -> {
        // nothing to answer
      }
    }
  }

  /** Real servers refuse a second subscription of a client to a channel. */
  private void subscribe(Subscription wanted) {
    if (subscriptions.stream().noneMatch(s -> s.link() == wanted.link() && s.channel() == wanted.channel())) {
      subscriptions.add(wanted);
    }
  }

  private void parameters(WebServerLink link, Map<String, Object> message) {
    Map<String, Object> answer = new LinkedHashMap<>(Map.of("op", "parameterValues", "parameters",
        parameters.entrySet().stream().map(e -> Map.of("name", e.getKey(), "value", e.getValue())).toList()));
    Optional.ofNullable(message.get("id")).ifPresent(id -> answer.put("id", id));
    link.say(JsonText.write(answer));
  }

  @Override
  public void binary(WebServerLink link, ByteBuffer bytes) {
    ByteBuffer in = bytes.order(ByteOrder.LITTLE_ENDIAN);
    if (in.get() == 1) {
      Map<String, Object> channel = advertised.get(link.hashCode() + " " + in.getInt());
      said.add(new Said(channel.get("topic").toString(), channel.get("encoding").toString(),
          channel.get("schemaName").toString(), in.slice().order(ByteOrder.LITTLE_ENDIAN)));
    } else {
      echo(link, in);
    }
  }

  /** All services answer with what they are asked. */
  private static void echo(WebServerLink link, ByteBuffer in) {
    int service = in.getInt();
    int call = in.getInt();
    byte[] encoding = new byte[in.getInt()];
    in.get(encoding);
    String name = new String(encoding, StandardCharsets.UTF_8);
    ByteBuffer out = ByteBuffer.allocate(13 + name.length() + in.remaining()).order(ByteOrder.LITTLE_ENDIAN);
    link.say(out.put((byte) 3).putInt(service).putInt(call).putInt(name.length()).put(encoding).put(in).array());
  }

  @Override
  public void close() {
    server.close();
  }
}
