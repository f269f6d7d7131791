package org.robotui.ui.control;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.robotui.api.input.Unreadable;
import org.robotui.data.record.FieldShape;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.RecordShape;

/** A field that is typed in one line. */
final class FormLeaf implements FormNode {
  /** What nobody edits in one line is kept as it came. */
  private static final int LONGEST = 1_000;

  private final String path;
  private final String name;
  private final FieldShape shape;
  private final List<RecordShape.Constant> choices;
  private final FormInput input;
  private String text = "";
  private Optional<Kept> kept = Optional.empty();

  FormLeaf(String path, String name, FieldShape shape, List<RecordShape.Constant> choices, FormInput input) {
    this.path = path;
    this.name = name;
    this.shape = shape;
    this.choices = choices;
    this.input = input;
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
  public FieldShape shape() {
    return shape;
  }

  /** Named values that fit; their names can be typed. */
  List<RecordShape.Constant> choices() {
    return choices;
  }

  String text() {
    return text;
  }

  void text(String typed) {
    text = typed;
  }

  /** Takes over what was typed into another one. */
  void take(FormLeaf other) {
    text = other.text;
    kept = other.kept;
  }

  /** What is wrong, as the end of a sentence. */
  Optional<String> problem() {
    try {
      read();
      return Optional.empty();
    } catch (Unreadable e) {
      return Optional.of(e.getMessage());
    }
  }

  @Override
  public Object value() {
    try {
      return read();
    } catch (Unreadable e) {
      throw new IllegalStateException(path + " " + e.getMessage(), e);
    }
  }

  private Object read() throws Unreadable {
    if (kept.isPresent() && kept.get().text().equals(text)) {
      return kept.get().values();
    }
    Optional<String> chosen =
        choices.stream().filter(c -> c.name().equals(text.strip())).map(RecordShape.Constant::value).findFirst();
    return input.read(shape, chosen.orElse(text));
  }

  @Override
  public void problems(List<FormProblem> into) {
    problem().ifPresent(sentence -> into.add(new FormProblem(path, sentence)));
  }

  @Override
  public void reset() {
    text = "";
    kept = Optional.empty();
  }

  @Override
  public void fill(FieldValue value) {
    reset();
    switch (value) {
      case FieldValue.Time t -> text = RecordText.shortSeconds(t.nanos());
      case FieldValue.Numbers n -> numbers(n);
      case FieldValue.Items i -> text = i.values().stream().map(RecordText::line).collect(Collectors.joining(", "));
      case FieldValue.Nested n -> {}
      default -> text = RecordText.line(value);
    }
    if (problem().isPresent()) {
      reset();
    }
  }

  private void numbers(FieldValue.Numbers numbers) {
    int size = numbers.values().size();
    if (size > LONGEST) {
      text = size + " numbers as received";
      kept = Optional.of(new Kept(text, IntStream.range(0, size).mapToObj(numbers.values()::get).toList()));
    } else {
      text = IntStream.range(0, size).mapToObj(i -> RecordText.number(numbers.values().get(i)))
          .collect(Collectors.joining(", "));
    }
  }

  private record Kept(String text, List<Double> values) {}
}
