package org.robotui.ros2.name;

import java.util.List;
import java.util.Objects;

/**
 * Turns names as programs write them into whole ones, as seen from one node: whole ({@code /a}), relative ({@code a})
 * or private ({@code ~/a}), with {@code {node}}, {@code {ns}} and {@code {namespace}} replaced, then remapped.
 *
 * @param node the node's own whole name
 * @param rules in the order in which they are tried; the first that fits counts
 */
public record Ros2NameResolver(Ros2Name node, List<RemapRule> rules) {

  /** Copies the rules. */
  public Ros2NameResolver {
    Objects.requireNonNull(node, "node");
    rules = List.copyOf(rules);
  }

  /**
   * The resolver of a node that is about to be made.
   *
   * @param namespace the namespace that its owner wants
   * @param name the base name that its owner wants
   * @param rules may give it another namespace and name
   * @return the resolver, of the node's final name
   * @throws IllegalArgumentException if a name is none
   */
  public static Ros2NameResolver of(Ros2Name namespace, String name, List<RemapRule> rules) {
    String base = first(rules, name, RemapRule.Kind.NODE, name);
    String home = first(rules, name, RemapRule.Kind.NAMESPACE, namespace.text());
    return new Ros2NameResolver(Ros2Name.of(home.startsWith("/") ? home : "/" + home).join(base), rules);
  }

  private static String first(List<RemapRule> rules, String node, RemapRule.Kind kind, String otherwise) {
    return rules.stream().filter(rule -> rule.isFor(node, kind)).map(RemapRule::to).findFirst().orElse(otherwise);
  }

  /**
   * Resolves the name of a topic.
   *
   * @param text as a program writes it
   * @return the whole name, remapped if a rule is for it
   * @throws IllegalArgumentException if it is no name
   */
  public Ros2Name topic(String text) {
    return remap(expand(text), RemapRule.Kind.TOPIC);
  }

  /**
   * Resolves the name of a service or an action.
   *
   * @param text as a program writes it
   * @return the whole name, remapped if a rule is for it
   * @throws IllegalArgumentException if it is no name
   */
  public Ros2Name service(String text) {
    return remap(expand(text), RemapRule.Kind.SERVICE);
  }

  private Ros2Name remap(Ros2Name name, RemapRule.Kind kind) {
    return rules.stream().filter(rule -> rule.isFor(node.base(), kind) && expand(rule.from()).equals(name))
        .map(rule -> expand(rule.to())).findFirst().orElse(name);
  }

  private Ros2Name expand(String text) {
    String namespace = node.namespace().text();
    String filled = text.replace("{node}", node.base()).replace("{ns}", namespace).replace("{namespace}", namespace);
    String clean = filled.startsWith("//") ? filled.substring(1) : filled;
    if (clean.startsWith("/")) {
      return Ros2Name.of(clean);
    }
    if (clean.equals("~")) {
      return node;
    }
    return clean.startsWith("~/") ? node.join(clean.substring(2)) : node.namespace().join(clean);
  }
}
