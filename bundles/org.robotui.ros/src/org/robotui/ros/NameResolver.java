package org.robotui.ros;

import java.util.LinkedHashMap;
import java.util.Map;

/**
 * Turns names into global ones as seen from one node, with remappings applied.
 *
 * @param node the node's own global name, the home of private names
 * @param namespace the global namespace in which relative names live
 * @param remappings from name to name, both already global
 */
public record NameResolver(GraphName node, GraphName namespace, Map<GraphName, GraphName> remappings) {

  /** Copies the remappings. */
  public NameResolver {
    remappings = Map.copyOf(remappings);
  }

  /**
   * The resolver of a node.
   *
   * @param node the node's global name
   * @param namespace the namespace of relative names
   * @param remappings from name to name as the user wrote them
   * @return a resolver with both sides of each remapping resolved
   */
  public static NameResolver of(GraphName node, GraphName namespace, Map<String, String> remappings) {
    NameResolver plain = new NameResolver(node, namespace, Map.of());
    Map<GraphName, GraphName> resolved = new LinkedHashMap<>();
    remappings
        .forEach((from, to) -> resolved.put(plain.globalize(GraphName.of(from)), plain.globalize(GraphName.of(to))));
    return new NameResolver(node, namespace, resolved);
  }

  /**
   * Resolves a name.
   *
   * @param name a global, relative or private name
   * @return the global name, remapped if there is a remapping for it
   * @throws InvalidNameException if the text is no name
   */
  public GraphName resolve(String name) {
    GraphName global = globalize(GraphName.of(name));
    return remappings.getOrDefault(global, global);
  }

  private GraphName globalize(GraphName name) {
    if (name.isGlobal()) {
      return name;
    }
    return (name.isPrivate() ? node : namespace).join(name);
  }
}
