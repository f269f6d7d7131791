package org.robotui.rosbridge;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.net.call.Outcome;
import org.robotui.rosbridge.internal.TypeText;
import org.robotui.web.tree.JsonText;
import org.robotui.web.tree.TreeException;
import org.robotui.web.tree.Trees;

/**
 * Asks {@code rosapi}, the node beside a bridge that knows what there is. Every question blocks. Safe for all threads.
 */
public final class RosApi {

  private final RosbridgeClient client;
  private final Duration patience;

  /**
   * What a node does.
   *
   * @param subscribing topics
   * @param publishing topics
   * @param services that it serves
   */
  public record NodeDetails(List<String> subscribing, List<String> publishing, List<String> services) {}

  /** Reads an answer. */
  @FunctionalInterface
  private interface Reader<T> {
    T read(Map<String, Object> answer) throws TreeException;
  }

  /**
   * Asks by a client.
   *
   * @param client of the bridge
   * @param patience how long to wait for each answer
   */
  public RosApi(RosbridgeClient client, Duration patience) {
    this.client = client;
    this.patience = patience;
  }

  private <T> Outcome<T> ask(String question, Map<String, Object> arguments, Reader<T> reader)
      throws InterruptedException {
    Outcome<Map<String, Object>> answer = client.call("/rosapi/" + question, arguments, patience);
    if (!(answer instanceof Outcome.Done<Map<String, Object>> done)) {
      return new Outcome.Failed<>("rosapi/" + question + ": " + answer.reason());
    }
    try {
      return new Outcome.Done<>(reader.read(done.value()));
    } catch (TreeException e) {
      return new Outcome.Failed<>("rosapi/" + question + " cannot be read: " + e.getMessage());
    }
  }

  /**
   * All topics that somebody publishes or subscribes.
   *
   * @return the type of each by name, or why there is no answer
   * @throws InterruptedException if the thread was interrupted
   */
  public Outcome<Map<String, String>> topics() throws InterruptedException {
    return ask("topics", Map.of(), answer -> pairs(answer, "topics", "types"));
  }

  private static Map<String, String> pairs(Map<String, Object> answer, String names, String values)
      throws TreeException {
    List<String> keys = Trees.texts(answer, names);
    List<String> texts = Trees.texts(answer, values);
    Map<String, String> pairs = new LinkedHashMap<>();
    for (int i = 0; i < Math.min(keys.size(), texts.size()); i++) {
      pairs.put(keys.get(i), texts.get(i));
    }
    return pairs;
  }

  /**
   * All nodes.
   *
   * @return their names, or why there is no answer
   * @throws InterruptedException if the thread was interrupted
   */
  public Outcome<List<String>> nodes() throws InterruptedException {
    return ask("nodes", Map.of(), answer -> Trees.texts(answer, "nodes"));
  }

  /**
   * All services.
   *
   * @return their names, or why there is no answer
   * @throws InterruptedException if the thread was interrupted
   */
  public Outcome<List<String>> services() throws InterruptedException {
    return ask("services", Map.of(), answer -> Trees.texts(answer, "services"));
  }

  /**
   * All parameters.
   *
   * @return their names, or why there is no answer
   * @throws InterruptedException if the thread was interrupted
   */
  public Outcome<List<String>> parameters() throws InterruptedException {
    return ask("get_param_names", Map.of(), answer -> Trees.texts(answer, "names"));
  }

  /**
   * What a node does.
   *
   * @param name the node
   * @return its topics and services, or why there is no answer
   * @throws InterruptedException if the thread was interrupted
   */
  public Outcome<NodeDetails> node(String name) throws InterruptedException {
    return ask("node_details", Map.of("node", name), answer -> new NodeDetails(Trees.texts(answer, "subscribing"),
        Trees.texts(answer, "publishing"), Trees.texts(answer, "services")));
  }

  /**
   * The type of a service.
   *
   * @param service its name
   * @return the type, or why there is no answer
   * @throws InterruptedException if the thread was interrupted
   */
  public Outcome<String> serviceType(String service) throws InterruptedException {
    return ask("service_type", Map.of("service", service), answer -> Trees.text(answer, "type"));
  }

  /**
   * The definition of a type of messages.
   *
   * @param type its name
   * @return its full text with the types that it refers to, or why there is no answer
   * @throws InterruptedException if the thread was interrupted
   */
  public Outcome<String> message(String type) throws InterruptedException {
    return definition("message_details", type);
  }

  /**
   * The definitions of all types that topics have; by a bridge of ROS 2 and by newer ones of ROS 1. One that the bridge
   * could not read is a comment that begins with {@code # failed}.
   *
   * @return the full text of each by type, or why there is no answer
   * @throws InterruptedException if the thread was interrupted
   */
  public Outcome<Map<String, String>> definitions() throws InterruptedException {
    return ask("topics_and_raw_types", Map.of(), answer -> pairs(answer, "types", "typedefs_full_text"));
  }

  /**
   * Which distribution of ROS it is of.
   *
   * @return such as {@code jazzy}, or why there is no answer
   * @throws InterruptedException if the thread was interrupted
   */
  public Outcome<String> distribution() throws InterruptedException {
    return ask("get_ros_version", Map.of(), answer -> Trees.text(answer, "distro"));
  }

  /**
   * The definition of the requests of a type of services.
   *
   * @param type its name
   * @return the full text, or why there is no answer
   * @throws InterruptedException if the thread was interrupted
   */
  public Outcome<String> request(String type) throws InterruptedException {
    return definition("service_request_details", type);
  }

  /**
   * The definition of the responses of a type of services.
   *
   * @param type its name
   * @return the full text, or why there is no answer
   * @throws InterruptedException if the thread was interrupted
   */
  public Outcome<String> response(String type) throws InterruptedException {
    return definition("service_response_details", type);
  }

  private Outcome<String> definition(String question, String type) throws InterruptedException {
    return ask(question, Map.of("type", type), answer -> {
      List<Map<String, Object>> types = new ArrayList<>();
      for (Object each : Trees.list(answer, "typedefs")) {
        types.add(Trees.object(each));
      }
      return TypeText.of(types);
    });
  }

  /**
   * Reads a parameter.
   *
   * @param name its name
   * @return its value, none where it is not set, or why there is no answer
   * @throws InterruptedException if the thread was interrupted
   */
  public Outcome<Optional<Object>> parameter(String name) throws InterruptedException {
    return ask("get_param", Map.of("name", name, "default", ""), answer -> {
      String value = Trees.optionalText(answer, "value").orElse("");
      return value.isBlank() || value.equals("\"\"") ? Optional.empty() : Optional.of(JsonText.read(value));
    });
  }

  /**
   * Sets a parameter.
   *
   * @param name its name
   * @param value a tree of plain values
   * @return nothing, or why there is no answer
   * @throws InterruptedException if the thread was interrupted
   */
  public Outcome<Boolean> set(String name, Object value) throws InterruptedException {
    return ask("set_param", Map.of("name", name, "value", JsonText.write(value)),
        answer -> !Boolean.FALSE.equals(answer.get("successful")));
  }
}
