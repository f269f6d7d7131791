package org.robotui.urdf.internal;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** An element of a document. Complete once the reader gave it out; not changed afterwards. */
public final class XmlNode {
  private final String name;
  private final Map<String, String> attributes;
  private final int line;
  private final List<XmlNode> children = new ArrayList<>(0);
  private String text = "";

  XmlNode(String name, Map<String, String> attributes, int line) {
    this.name = name;
    this.attributes = attributes;
    this.line = line;
  }

  void add(XmlNode child) {
    children.add(child);
  }

  void text(String content) {
    text = content;
  }

  /** The name of the element. */
  public String name() {
    return name;
  }

  /** Where it begins, from 1. */
  public int line() {
    return line;
  }

  /** What stands in it beside elements. */
  public String text() {
    return text;
  }

  /** All elements in it. */
  public List<XmlNode> children() {
    return children;
  }

  /** The elements of a name in it. */
  public List<XmlNode> children(String child) {
    return children.stream().filter(node -> node.name.equals(child)).toList();
  }

  /** The first element of a name in it. */
  public Optional<XmlNode> child(String child) {
    return children.stream().filter(node -> node.name.equals(child)).findFirst();
  }

  /** The first element at the end of a path of names. */
  public Optional<XmlNode> at(String... path) {
    Optional<XmlNode> at = Optional.of(this);
    for (String step : path) {
      at = at.flatMap(node -> node.child(step));
    }
    return at;
  }

  /** An attribute. */
  public Optional<String> attribute(String attribute) {
    return Optional.ofNullable(attributes.get(attribute));
  }

  /** An attribute that must be there. */
  public String required(String attribute) throws Refusal {
    String value = attributes.get(attribute);
    if (value == null || value.isBlank()) {
      throw refusal("<" + name + "> has no " + attribute + ", write <" + name + " " + attribute + "=\"...\">");
    }
    return value.strip();
  }

  /** An element that must be there. */
  public XmlNode requiredChild(String child) throws Refusal {
    Optional<XmlNode> node = child(child);
    if (node.isEmpty()) {
      String owner = attributes.containsKey("name") ? " '" + attributes.get("name") + "'" : "";
      throw refusal("<" + name + ">" + owner + " has no <" + child + ">, write one in it");
    }
    return node.get();
  }

  /** Says that something is wrong here. */
  public Refusal refusal(String why) {
    return new Refusal(line, why);
  }
}
