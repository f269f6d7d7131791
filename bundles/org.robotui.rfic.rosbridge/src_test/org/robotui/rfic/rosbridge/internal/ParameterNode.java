package org.robotui.rfic.rosbridge.internal;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.robotui.web.tree.TreeException;
import org.robotui.web.tree.Trees;

/** The services for parameters of a node of ROS 2, which refuses what is named {@code fixed}. */
public final class ParameterNode {
  /** Values as rcl_interfaces/msg/ParameterValue has them. */
  public final Map<String, Map<String, Object>> values = new ConcurrentHashMap<>();

  /**
   * Answers a call.
   *
   * @param service its name
   * @param arguments its request
   * @return the response
   * @throws TreeException where something is missing
   */
  public Map<String, Object> answer(String service, Map<String, Object> arguments) throws TreeException {
    return switch (service.substring(service.lastIndexOf('/') + 1)) {
      case "list_parameters" -> Map.of("result", Map.of("names", values.keySet().stream().sorted().toList()));
      case "get_parameters" -> Map.of("values", Trees.texts(arguments, "names").stream()
          .map(name -> values.getOrDefault(name, Map.of("type", 0))).toList());
      default -> Map.of("results", results(arguments));
    };
  }

  private List<Map<String, Object>> results(Map<String, Object> arguments) throws TreeException {
    List<Map<String, Object>> results = new ArrayList<>();
    for (Object each : Trees.list(arguments, "parameters")) {
      Map<String, Object> parameter = Trees.object(each);
      String name = Trees.text(parameter, "name");
      boolean fixed = name.equals("fixed");
      if (!fixed) {
        values.put(name, Trees.object(parameter.get("value")));
      }
      results.add(Map.of("successful", !fixed, "reason", fixed ? "it is fixed" : ""));
    }
    return results;
  }
}
