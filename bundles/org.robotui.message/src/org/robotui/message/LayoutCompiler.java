package org.robotui.message;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** Computes layouts bottom up, each type once, and refuses types that contain themselves. */
final class LayoutCompiler {

  private static final int MAX_FIELDS = 2000;

  private final Map<String, MessageDefinition> nested;
  private final Map<String, Layout> done = new HashMap<>();
  private final Set<String> open = new HashSet<>();

  LayoutCompiler(Map<String, MessageDefinition> nested) {
    this.nested = nested;
  }

  Layout compile(MessageDefinition definition) throws DefinitionException {
    if (!open.add(definition.type())) {
      throw new DefinitionException(definition.type(), "the type contains itself");
    }
    if (open.size() > Dependencies.MAX_DEPTH) {
      throw new DefinitionException(
          definition.type(), "types are nested more than " + Dependencies.MAX_DEPTH + " deep");
    }
    if (definition.fields().size() > MAX_FIELDS) {
      throw new DefinitionException(definition.type(), "more than " + MAX_FIELDS + " fields");
    }
    List<Layout.Field> fields = new ArrayList<>();
    for (FieldDefinition each : definition.fields()) {
      fields.add(field(each));
    }
    open.remove(definition.type());
    long size = 0;
    boolean fixed = true;
    for (Layout.Field each : fields) {
      size = Layout.saturatedSum(size, each.minSize());
      fixed &= each.isFixed();
    }
    return new Layout(definition.type(), List.copyOf(fields), size, fixed);
  }

  private Layout.Field field(FieldDefinition field) throws DefinitionException {
    Primitive primitive = field.type().primitive().orElse(null);
    if (primitive != null && primitive.isText()) {
      return new Layout.Field(field.name(), field.type(), primitive, null, Integer.BYTES, false, field.initial());
    }
    if (primitive != null) {
      return new Layout.Field(field.name(), field.type(), primitive, null, primitive.size(), true, field.initial());
    }
    Layout layout = nestedLayout(field.type().base());
    if (layout.minSize() == 0 && field.type().length() > Layout.MAX_EMPTY_ELEMENTS) {
      throw new DefinitionException(layout.type(), "field " + field.name() + " repeats nothing too often");
    }
    return new Layout.Field(field.name(), field.type(), null, layout, layout.minSize(), layout.fixedSize(),
        field.initial());
  }

  private Layout nestedLayout(String type) throws DefinitionException {
    Layout known = done.get(type);
    if (known == null) {
      known = compile(nested.get(type));
      done.put(type, known);
    }
    return known;
  }
}
