package org.robotui.ros.internal.master;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.ros.XmlRpcValue;
import org.robotui.ros.XmlRpcValue.Struct;

/** The parameters: a tree of namespaces, never changed but replaced along the changed path. */
record ParameterTree(Struct root) {

  static final Struct EMPTY = new Struct(Map.of());

  static ParameterTree empty() {
    return new ParameterTree(EMPTY);
  }

  private static List<String> path(String key) {
    return Arrays.stream(key.split("/")).filter(part -> !part.isEmpty()).toList();
  }

  Optional<XmlRpcValue> get(String key) {
    XmlRpcValue value = root;
    for (String part : path(key)) {
      if (!(value instanceof Struct struct) || !struct.members().containsKey(part)) {
        return Optional.empty();
      }
      value = struct.members().get(part);
    }
    return Optional.of(value);
  }

  /** The tree with a parameter set; what stood in its way is replaced, as every ROS master does. */
  ParameterTree set(String key, XmlRpcValue value) {
    List<String> path = path(key);
    if (path.isEmpty() && !(value instanceof Struct)) {
      throw new IllegalArgumentException("the root namespace can only be set to a struct");
    }
    return new ParameterTree((Struct) with(root, path, value));
  }

  private static XmlRpcValue with(XmlRpcValue node, List<String> path, XmlRpcValue value) {
    if (path.isEmpty()) {
      return value;
    }
    Map<String, XmlRpcValue> members = new LinkedHashMap<>(node instanceof Struct struct ? struct.members() : Map.of());
    XmlRpcValue child = members.getOrDefault(path.get(0), EMPTY);
    members.put(path.get(0), with(child, path.subList(1, path.size()), value));
    return new Struct(members);
  }

  /** The tree without a parameter; empty if it is not set. */
  Optional<ParameterTree> delete(String key) {
    List<String> path = path(key);
    if (path.isEmpty()) {
      return Optional.of(empty());
    }
    return get(key).map(there -> new ParameterTree(without(root, path)));
  }

  private static Struct without(Struct node, List<String> path) {
    Map<String, XmlRpcValue> members = new LinkedHashMap<>(node.members());
    if (path.size() == 1) {
      members.remove(path.get(0));
    } else {
      members.computeIfPresent(path.get(0), (name, child) -> without((Struct) child, path.subList(1, path.size())));
    }
    return new Struct(members);
  }

  /** The names of all parameters that are no namespaces. */
  List<String> names() {
    List<String> names = new ArrayList<>();
    collect("", root, names);
    return names;
  }

  private static void collect(String prefix, Struct node, List<String> names) {
    node.members().forEach((name, value) -> {
      if (value instanceof Struct struct) {
        collect(prefix + "/" + name, struct, names);
      } else {
        names.add(prefix + "/" + name);
      }
    });
  }

  /**
   * Looks for a parameter from a namespace upwards. The first part of the key decides where; whether the rest of it is
   * set there does not matter, as every ROS master does.
   */
  Optional<String> search(String namespace, String key) {
    if (key.startsWith("/")) {
      return get(key).map(there -> key);
    }
    String first = key.split("/")[0];
    for (String at = namespace;; at = MasterNames.parent(at)) {
      if (get(at + "/" + first).isPresent()) {
        return Optional.of(MasterNames.clean(at + "/" + key));
      }
      if (at.equals("/")) {
        return Optional.empty();
      }
    }
  }
}
