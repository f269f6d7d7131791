package org.robotui.ui.control;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.robotui.data.record.FieldShape;
import org.robotui.data.record.FieldValue;

/** The fields of a record within a form. */
final class FormGroup implements FormNode {
  private final String path;
  private final String name;
  private final FieldShape.Nested shape;
  private final List<FormNode> fields;

  FormGroup(String path, String name, FieldShape.Nested shape, List<FormNode> fields) {
    this.path = path;
    this.name = name;
    this.shape = shape;
    this.fields = List.copyOf(fields);
  }

  @Override
  public String path() {
    return path;
  }

  @Override
  public String name() {
    return name;
  }

  @Override
  public FieldShape.Nested shape() {
    return shape;
  }

  List<FormNode> fields() {
    return fields;
  }

  @Override
  public Map<String, Object> value() {
    Map<String, Object> values = new LinkedHashMap<>();
    fields.forEach(field -> values.put(field.name(), field.value()));
    return values;
  }

  @Override
  public void problems(List<FormProblem> into) {
    fields.forEach(field -> field.problems(into));
  }

  @Override
  public void reset() {
    fields.forEach(FormNode::reset);
  }

  @Override
  public void fill(FieldValue value) {
    reset();
    if (value instanceof FieldValue.Nested nested) {
      fields.forEach(field -> nested.value().field(field.name()).ifPresent(field::fill));
    }
  }
}
