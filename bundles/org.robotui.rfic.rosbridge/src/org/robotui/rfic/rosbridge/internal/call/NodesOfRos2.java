package org.robotui.rfic.rosbridge.internal.call;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.port.CallException;
import org.robotui.web.tree.TreeException;
import org.robotui.web.tree.Trees;

/**
 * The parameters of nodes of ROS 2, asked of the nodes by the services that each of them has. The rosapi of ROS 2 has
 * questions for them, too, but ends where one node lacks these services, and tells neither integers from reals nor
 * texts from numbers. A parameter is named by its node and its own name with a slash between them.
 */
final class NodesOfRos2 {
  private static final String LIST = "/list_parameters";
  /** Where rcl_interfaces/msg/ParameterValue has a value, by the number of its type. */
  private static final List<String> FIELDS = List.of("", "bool_value", "integer_value", "double_value", "string_value",
      "byte_array_value", "bool_array_value", "integer_array_value", "double_array_value", "string_array_value");
  private static final List<String> KINDS =
      List.of("nothing", "true or false", "a whole number", "a number", "a text", "a list of bytes",
          "a list of truth values", "a list of whole numbers", "a list of numbers", "a list of texts");

  private final Caller caller;
  private final Services services;

  /** Calls a service. */
  @FunctionalInterface
  interface Caller {
    Map<String, Object> call(String service, Map<String, Object> arguments) throws CallException;
  }

  /** Says which services there are. */
  @FunctionalInterface
  interface Services {
    List<String> names() throws CallException;
  }

  private record Place(String node, String name) {}

  NodesOfRos2(Caller caller, Services services) {
    this.caller = caller;
    this.services = services;
  }

  private List<String> nodes() throws CallException {
    return services.names().stream().filter(name -> name.endsWith(LIST))
        .map(name -> name.substring(0, name.length() - LIST.length())).sorted().toList();
  }

  /** All parameters. A node that does not answer hides none of the others. */
  List<String> parameters() throws CallException {
    List<String> names = new ArrayList<>();
    Optional<CallException> silent = Optional.empty();
    for (String node : nodes()) {
      try {
        Map<String, Object> answer = caller.call(node + LIST, Map.of());
        Trees.texts(Trees.object(answer.get("result")), "names").forEach(name -> names.add(node + "/" + name));
      } catch (CallException e) {
        silent = Optional.of(e);
      } catch (TreeException e) {
        silent = Optional.of(unreadable(node, e));
      }
    }
    if (names.isEmpty() && silent.isPresent()) {
      throw silent.get();
    }
    return names;
  }

  private static CallException unreadable(String node, TreeException e) {
    return new CallException("what " + node + " answers cannot be read: " + e.getMessage(), e);
  }

  /** Names of parameters may have slashes as well: the longest name of a node counts. */
  private Optional<Place> place(String name) throws CallException {
    return nodes().stream().filter(node -> name.startsWith(node + "/") && name.length() > node.length() + 1)
        .max(Comparator.comparingInt(String::length))
        .map(node -> new Place(node, name.substring(node.length() + 1)));
  }

  Optional<Object> value(String name) throws CallException {
    Optional<Place> place = place(name);
    if (place.isEmpty()) {
      return Optional.empty();
    }
    Map<String, Object> value = held(place.get());
    int type = type(value);
    return type == 0 ? Optional.empty() : Optional.ofNullable(value.get(FIELDS.get(type)));
  }

  private Map<String, Object> held(Place place) throws CallException {
    Map<String, Object> answer = caller.call(place.node() + "/get_parameters", Map.of("names", List.of(place.name())));
    try {
      List<?> values = Trees.list(answer, "values");
      return values.isEmpty() ? Map.of() : Trees.object(values.get(0));
    } catch (TreeException e) {
      throw unreadable(place.node(), e);
    }
  }

  private static int type(Map<String, Object> value) {
    int type = value.get("type") instanceof Number number ? number.intValue() : 0;
    return type > 0 && type < FIELDS.size() ? type : 0;
  }

  /** A parameter keeps its type: nodes of ROS 2 refuse another one. */
  void set(String name, Object value) throws CallException {
    Place place = place(name).orElseThrow(() -> new CallException("no node is there that has a parameter " + name));
    int type = type(held(place));
    if (type == 0) {
      throw new CallException(place.node() + " has no parameter " + place.name());
    }
    Object fitting = fitting(type, value)
        .orElseThrow(() -> new CallException(name + " holds " + KINDS.get(type) + ", not " + value));
    Map<String, Object> answer = caller.call(place.node() + "/set_parameters", Map.of("parameters",
        List.of(Map.of("name", place.name(), "value", Map.of("type", type, FIELDS.get(type), fitting)))));
    Optional<String> refused = refused(place, answer);
    if (refused.isPresent()) {
      throw new CallException(refused.get());
    }
  }

  private static Optional<String> refused(Place place, Map<String, Object> answer) throws CallException {
    try {
      List<?> results = Trees.list(answer, "results");
      Map<String, Object> result = results.isEmpty() ? Map.of() : Trees.object(results.get(0));
      return Boolean.TRUE.equals(result.get("successful")) ? Optional.empty()
          : Optional.of(place.node() + " refuses: " + Trees.optionalText(result, "reason").orElse(""));
    } catch (TreeException e) {
      throw unreadable(place.node(), e);
    }
  }

  /** A value as it is written for a type; none where it is no such value. */
  private static Optional<Object> fitting(int type, Object value) {
    if (type > 4) {
      return value instanceof Collection<?> all ? listed(type, all) : Optional.empty();
    }
    return switch (type) {
      case 1 -> Optional.of(value).filter(Boolean.class::isInstance);
      case 2 -> whole(value);
      case 3 -> Optional.of(value).filter(Number.class::isInstance).map(number -> ((Number) number).doubleValue());
      default -> Optional.of(value).filter(String.class::isInstance);
    };
  }

  private static Optional<Object> whole(Object value) {
    return value instanceof Number number && number.doubleValue() == Math.rint(number.doubleValue())
        ? Optional.of(number.longValue())
        : Optional.empty();
  }

  /** Types of lists are in the order of those of single values, with bytes before them. */
  private static Optional<Object> listed(int type, Collection<?> values) {
    List<Object> all = new ArrayList<>();
    for (Object each : values) {
      Optional<Object> one = type == 5 ? whole(each) : fitting(type - 5, each);
      if (one.isEmpty()) {
        return Optional.empty();
      }
      all.add(one.get());
    }
    return Optional.of(all);
  }
}
