package org.robotui.message;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/** Collects the types a definition refers to, depth first in the order of the fields, as ROS's full text has them. */
final class Dependencies {

  static final int MAX_DEPTH = 40;
  private static final int MAX_TYPES = 500;

  private final String root;
  private final DefinitionSource source;
  private final Map<String, MessageDefinition> found = new LinkedHashMap<>();

  private Dependencies(String root, DefinitionSource source) {
    this.root = root;
    this.source = source;
  }

  static Map<String, MessageDefinition> of(MessageDefinition definition, DefinitionSource source)
      throws DefinitionException {
    Dependencies collector = new Dependencies(definition.type(), source);
    collector.visit(definition, 0);
    return collector.found;
  }

  private void visit(MessageDefinition definition, int depth) throws DefinitionException {
    if (depth > MAX_DEPTH) {
      throw new DefinitionException(root, "types are nested more than " + MAX_DEPTH + " deep");
    }
    for (FieldDefinition field : definition.fields()) {
      String type = field.type().base();
      if (field.type().primitive().isEmpty() && !found.containsKey(type)) {
        MessageDefinition nested = load(definition, field);
        found.put(type, nested);
        visit(nested, depth + 1);
      }
    }
  }

  private MessageDefinition load(MessageDefinition holder, FieldDefinition field) throws DefinitionException {
    String type = field.type().base();
    if (type.equals(root)) {
      throw new DefinitionException(root, "the type contains itself");
    }
    if (found.size() >= MAX_TYPES) {
      throw new DefinitionException(root, "more than " + MAX_TYPES + " types are involved");
    }
    Optional<MessageDefinition> known = source.find(type);
    if (known.isEmpty()) {
      throw new DefinitionException(root,
          "the type " + type + " of field " + holder.type() + "." + field.name() + " is not known");
    }
    return known.get();
  }
}
