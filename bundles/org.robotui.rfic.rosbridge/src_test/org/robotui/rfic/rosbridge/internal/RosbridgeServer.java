package org.robotui.rfic.rosbridge.internal;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicInteger;
import org.robotui.message.Generation;
import org.robotui.message.LocalDefinitions;
import org.robotui.message.MessageDefinition;
import org.robotui.message.MessageRegistry;
import org.robotui.message.MessageSchema;
import org.robotui.message.SchemaLookup;
import org.robotui.testkit.web.WebCaller;
import org.robotui.testkit.web.WebServer;
import org.robotui.testkit.web.WebServerLink;
import org.robotui.web.tree.JsonText;
import org.robotui.web.tree.TreeException;
import org.robotui.web.tree.Trees;

/**
 * A bridge that keeps protocol 2, with a node rosapi and one more, which has a laser, odometry and wheels. Of ROS 2 its
 * rosapi ends on the same questions as that of rosbridge_suite 2.1.0.
 */
final class RosbridgeServer implements WebCaller, AutoCloseable {
  private static final Map<String, String> TOPICS = Map.of("/odom", "nav_msgs/Odometry", "/scan",
      "sensor_msgs/LaserScan", "/cmd_vel", "geometry_msgs/Twist");

  private static final Map<String, Object> SET_BOOL = Map.of("type", "std_srvs/SetBoolRequest", "fieldnames",
      List.of("data"), "fieldtypes", List.of("bool"), "fieldarraylen", List.of(-1));
  private static final Map<String, Object> SET_BOOL_ANSWER = Map.of("type", "std_srvs/SetBoolResponse", "fieldnames",
      List.of("success", "message"), "fieldtypes", List.of("bool", "string"), "fieldarraylen", List.of(-1, -1));

  private static final List<String> ENDING = List.of("message_details", "service_request_details",
      "service_response_details", "get_param_names", "get_param", "set_param");

  /** A subscription of a client. */
  record Subscription(WebServerLink link, String topic, String compression) {}

  final List<Subscription> subscriptions = new CopyOnWriteArrayList<>();
  /** What clients announced: by link and topic. */
  final Map<String, String> advertised = new ConcurrentHashMap<>();
  final Queue<Map<String, Object>> said = new ConcurrentLinkedQueue<>();
  final Map<String, String> parameters = new ConcurrentHashMap<>();
  final ParameterNode settings = new ParameterNode();
  /** The services that clients offer, with their types. */
  final Map<String, String> services = new ConcurrentHashMap<>();
  final Queue<Map<String, Object>> responses = new ConcurrentLinkedQueue<>();
  /** How often each service was called. */
  final Map<String, AtomicInteger> asked = new ConcurrentHashMap<>();
  final List<String> nodes = new CopyOnWriteArrayList<>(List.of("/base", "/rosbridge_websocket"));
  volatile boolean rosapiEnded;
  private final Generation generation;
  private final List<WebServerLink> links = new CopyOnWriteArrayList<>();
  private final WebServer server;

  RosbridgeServer(Generation generation) throws IOException {
    this.generation = generation;
    this.server = new WebServer(this);
  }

  int port() {
    return server.port();
  }

  void tell(String text) {
    links.forEach(link -> link.say(text));
  }

  /** Says a message to those who have subscribed, as each has asked for it. */
  void publish(String topic, Map<String, Object> fields, ByteBuffer raw) {
    for (Subscription each : subscriptions) {
      if (each.topic().equals(topic) && each.compression().equals("cbor-raw")) {
        each.link().say(cborRaw(topic, raw));
      } else if (each.topic().equals(topic)) {
        each.link().say(JsonText.write(Map.of("op", "publish", "topic", topic, "msg", fields)));
      }
    }
  }

  private static byte[] cborRaw(String topic, ByteBuffer raw) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    out.write(0xa3);
    text(out, "op");
    text(out, "publish");
    text(out, "topic");
    text(out, topic);
    text(out, "msg");
    out.write(0xa3);
    text(out, "secs");
    out.write(1);
    text(out, "nsecs");
    out.write(2);
    text(out, "bytes");
    out.write(0x5a);
    out.writeBytes(ByteBuffer.allocate(4).putInt(raw.remaining()).array());
    byte[] bytes = new byte[raw.remaining()];
    raw.duplicate().get(bytes);
    out.writeBytes(bytes);
    return out.toByteArray();
  }

  private static void text(ByteArrayOutputStream out, String text) {
    out.write(0x60 | text.length());
    out.writeBytes(text.getBytes(StandardCharsets.US_ASCII));
  }

  @Override
  public void opened(WebServerLink link) {
    links.add(link);
  }

  @Override
  public void closed(WebServerLink link) {
    links.remove(link);
    subscriptions.removeIf(each -> each.link() == link);
    advertised.keySet().removeIf(key -> key.startsWith(link.hashCode() + " "));
  }

  @Override
  public void binary(WebServerLink link, ByteBuffer bytes) {
    throw new IllegalStateException("clients say nothing in bytes");
  }

  @Override
  public void text(WebServerLink link, String text) {
    try {
      Map<String, Object> message = Trees.object(JsonText.read(text));
      String topic = Trees.optionalText(message, "topic").orElse("");
      switch (Trees.text(message, "op")) {
        case "subscribe" -> subscriptions.add(new Subscription(link, topic, Trees.text(message, "compression")));
        case "unsubscribe" -> subscriptions.removeIf(each -> each.link() == link && each.topic().equals(topic));
        case "advertise" -> advertised.put(link.hashCode() + " " + topic, Trees.text(message, "type"));
        case "unadvertise" -> advertised.remove(link.hashCode() + " " + topic);
        case "publish" -> said.add(Trees.object(message.get("msg")));
        case "advertise_service" -> services.put(Trees.text(message, "service"), Trees.text(message, "type"));
        case "unadvertise_service" -> services.remove(Trees.text(message, "service"));
        case "service_response" -> responses.add(message);
        case "call_service" -> link.say(JsonText.write(answer(message)));
        case String other -> throw new IllegalStateException(other);
      }
    } catch (TreeException e) {
      throw new IllegalStateException(text, e);
    }
  }

  private Map<String, Object> answer(Map<String, Object> call) throws TreeException {
    String service = Trees.text(call, "service");
    Map<String, Object> arguments = Trees.object(call.get("args"));
    Map<String, Object> answer = new LinkedHashMap<>(Map.of("op", "service_response", "service", service, "id",
        Trees.text(call, "id"), "result", true));
    asked.computeIfAbsent(service, s -> new AtomicInteger()).incrementAndGet();
    String question = service.replaceFirst("/rosapi/", "");
    rosapiEnded |= generation == Generation.ROS2 && ENDING.contains(question);
    if (rosapiEnded && service.startsWith("/rosapi/")) {
      answer.putAll(Map.of("result", false, "values", "Service " + service + " does not exist"));
      return answer;
    }
    switch (question) {
      case "topics" -> answer.put("values", Map.of("topics", List.copyOf(TOPICS.keySet()), "types",
          TOPICS.values().stream().map(this::written).toList()));
      case "nodes" -> answer.put("values", Map.of("nodes", nodes));
      case "node_details" -> answer.put("values", details(Trees.text(arguments, "node")));
      case "message_details" -> answer.put("values", Map.of("typedefs", types(Trees.text(arguments, "type"))));
      case "service_request_details" -> answer.put("values", Map.of("typedefs", List.of(SET_BOOL)));
      case "service_response_details" -> answer.put("values", Map.of("typedefs", List.of(SET_BOOL_ANSWER)));
      case "topics_and_raw_types" -> answer.put("values", Map.of("topics", List.copyOf(TOPICS.keySet()), "types",
          TOPICS.values().stream().map(this::written).toList(), "typedefs_full_text",
          TOPICS.values().stream().map(type -> schema(type).info().definition()).toList()));
      case "get_ros_version" -> answer.put("values", Map.of("version", 2, "distro", "jazzy"));
      case "services" -> answer.put("values", Map.of("services", List.of("/echo", "/base/list_parameters")));
      case "service_type" -> answer.put("values",
          Map.of("type", generation == Generation.ROS2 ? "odd_srvs/srv/Echo" : "odd_srvs/Echo"));
      case "/base/list_parameters", "/base/get_parameters",
          "/base/set_parameters" -> answer.put("values", settings.answer(service, arguments));
      case "get_param_names" -> answer.put("values", Map.of("names", List.copyOf(parameters.keySet())));
      case "get_param" -> answer.put("values",
          Map.of("value", parameters.getOrDefault(Trees.text(arguments, "name"), "")));
      case "set_param" -> {
        parameters.put(Trees.text(arguments, "name"), Trees.text(arguments, "value"));
        answer.put("values", Map.of());
      }
      case "/echo" -> answer.put("values", arguments);
      default -> {
        answer.put("result", false);
        answer.put("values", "there is no service " + service);
      }
    }
    return answer;
  }

  private String written(String type) {
    return generation == Generation.ROS2 ? type.replace("/", "/msg/") : type;
  }

  /** What a bridge subscribes for its clients is its own. */
  private Map<String, Object> details(String node) {
    boolean base = node.equals("/base");
    return Map.of("subscribing", base ? List.of("/cmd_vel") : List.of("/odom"), "publishing",
        base ? List.of("/odom", "/scan") : List.of("/cmd_vel"), "services", List.of());
  }

  private List<Map<String, Object>> types(String type) {
    MessageSchema schema = schema(type);
    List<Map<String, Object>> types = new ArrayList<>(List.of(details(schema.definition())));
    schema.nested().values().forEach(each -> types.add(details(each)));
    return types;
  }

  private MessageSchema schema(String type) {
    MessageRegistry known = new MessageRegistry(new LocalDefinitions(List.of(), List.of(), generation), generation);
    return ((SchemaLookup.Found<MessageSchema>) known.message(type)).schema();
  }

  private static Map<String, Object> details(MessageDefinition definition) {
    List<Integer> lengths = definition.fields().stream().map(f -> switch (f.type().arity()) {
      case ONE -> -1;
      case VARIABLE -> 0;
      case FIXED -> f.type().length();
    }).toList();
    return Map.of("type", definition.type(), "fieldnames", definition.fields().stream().map(f -> f.name()).toList(),
        "fieldtypes", definition.fields().stream().map(f -> f.type().base()).toList(), "fieldarraylen", lengths);
  }

  @Override
  public void close() {
    server.close();
  }
}
