package org.robotui.ros;

import java.net.URI;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import org.robotui.net.socket.HostPort;

/** Reads ROS environment variables and command lines. */
final class EnvironmentParser {

  private static final String DEFAULT_MASTER = "http://localhost:11311";

  private final Map<String, String> specials = new LinkedHashMap<>();
  private final Map<String, String> remappings = new LinkedHashMap<>();
  private final Map<String, XmlRpcValue> parameters = new LinkedHashMap<>();
  private final List<String> rest = new ArrayList<>();

  private EnvironmentParser() {}

  static RosEnvironment parse(Map<String, String> variables, List<String> arguments) {
    EnvironmentParser parser = new EnvironmentParser();
    arguments.forEach(parser::argument);
    return parser.environment(variables);
  }

  private void argument(String argument) {
    int split = argument.indexOf(":=");
    if (split <= 0) {
      rest.add(argument);
      return;
    }
    String name = argument.substring(0, split);
    String value = argument.substring(split + 2);
    if (name.startsWith("__")) {
      specials.put(name, value);
    } else if (name.startsWith("_")) {
      parameters.put(GraphName.of(name.substring(1)).text(), scalar(value));
    } else {
      remappings.put(GraphName.of(name).text(), GraphName.of(value).text());
    }
  }

  private RosEnvironment environment(Map<String, String> variables) {
    return new RosEnvironment(
        master(pick(variables, "__master", "ROS_MASTER_URI").orElse(DEFAULT_MASTER)),
        pick(variables, "__hostname", "ROS_HOSTNAME").or(() -> pick(variables, "__ip", "ROS_IP")),
        namespace(pick(variables, "__ns", "ROS_NAMESPACE").orElse("/")),
        Optional.ofNullable(specials.get("__name")).map(GraphName::of),
        remappings, parameters, rest);
  }

  private Optional<String> pick(Map<String, String> variables, String special, String variable) {
    return Optional.ofNullable(specials.get(special))
        .or(() -> Optional.ofNullable(variables.get(variable)))
        .filter(Predicate.not(String::isBlank))
        .map(String::strip);
  }

  private static URI master(String uri) {
    try {
      HostPort.ofUri(uri, "http");
      return URI.create(uri);
    } catch (IllegalArgumentException e) {
      throw new IllegalArgumentException("ROS_MASTER_URI: " + e.getMessage() + "; write for example " + DEFAULT_MASTER,
          e);
    }
  }

  private static GraphName namespace(String text) {
    return GraphName.of(text.startsWith("/") ? text : "/" + text);
  }

  /** As roscpp reads values on the command line: integer, float, truth value, else text. */
  private static XmlRpcValue scalar(String text) {
    if (text.matches("[+-]?\\d{1,9}")) {
      return XmlRpcValue.of(Integer.parseInt(text));
    }
    if (text.matches("[+-]?(\\d+\\.?\\d*|\\.\\d+)([eE][+-]?\\d+)?")) {
      return XmlRpcValue.of(Double.parseDouble(text));
    }
    return text.equalsIgnoreCase("true") || text.equalsIgnoreCase("false")
        ? XmlRpcValue.of(Boolean.parseBoolean(text))
        : XmlRpcValue.of(text);
  }
}
