package org.robotui.ui.control;

import java.time.Clock;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.input.Unreadable;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldShape;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.RecordShape;

/** What was typed into a form, and what it comes to. Display thread. */
final class FormModel {
  private final FormGroup root;
  private final FormInput input;

  FormModel(RecordShape shape, Clock clock) {
    input = new FormInput(clock);
    root = (FormGroup) node("", "", new FieldShape.Nested(shape), List.of());
  }

  FormGroup root() {
    return root;
  }

  RecordShape shape() {
    return root.shape().shape();
  }

  List<FormProblem> problems() {
    List<FormProblem> problems = new ArrayList<>();
    root.problems(problems);
    return problems;
  }

  Optional<Map<String, Object>> values() {
    return problems().isEmpty() ? Optional.of(root.value()) : Optional.empty();
  }

  void fill(DynamicRecord record) {
    root.fill(new FieldValue.Nested(record));
  }

  private FormNode node(String path, String name, FieldShape shape, List<RecordShape.Constant> constants) {
    return switch (shape) {
      case FieldShape.Nested n -> group(path, name, n);
      case FieldShape.Many m when !inOneLine(m.element()) -> new FormArray(path, name, m,
          i -> node(path + '[' + i + ']', "[" + i + "]", m.element(), constants));
      default -> new FormLeaf(path, name, shape, choices(name, shape, constants), input);
    };
  }

  private FormGroup group(String path, String name, FieldShape.Nested shape) {
    List<FormNode> fields = new ArrayList<>();
    for (RecordShape.Field field : shape.shape().fields()) {
      String at = path.isEmpty() ? field.name() : path + '.' + field.name();
      fields.add(node(at, field.name(), field.shape(), shape.shape().constants()));
    }
    return new FormGroup(path, name, shape, fields);
  }

  private static boolean inOneLine(FieldShape element) {
    return element instanceof FieldShape.Whole || element instanceof FieldShape.Real;
  }

  /**
   * Definitions do not say which field a constant is for: its name does where it begins like the field, else every one
   * that fits may be meant.
   */
  private List<RecordShape.Constant> choices(String name, FieldShape shape, List<RecordShape.Constant> constants) {
    List<RecordShape.Constant> fitting = constants.stream().filter(constant -> fits(shape, constant.value())).toList();
    String begin = name.toUpperCase(Locale.ROOT) + '_';
    List<RecordShape.Constant> own = fitting.stream().filter(constant -> constant.name().startsWith(begin)).toList();
    return own.isEmpty() ? fitting : own;
  }

  private boolean fits(FieldShape shape, String value) {
    boolean number = readable(new FieldShape.Real(Double.SIZE), value);
    return switch (shape) {
      case FieldShape.Whole w -> readable(w, value);
      case FieldShape.Real r -> number;
      case FieldShape.Text t -> !number;
      default -> false;
    };
  }

  private boolean readable(FieldShape shape, String value) {
    try {
      input.read(shape, value);
      return true;
    } catch (Unreadable e) {
      return false;
    }
  }
}
