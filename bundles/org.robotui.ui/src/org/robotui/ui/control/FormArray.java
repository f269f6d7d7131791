package org.robotui.ui.control;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntFunction;
import org.robotui.data.record.FieldShape;
import org.robotui.data.record.FieldValue;

/** Many values of one form, each with a place of its own in the form. */
final class FormArray implements FormNode {
  /** More are not filled in: nobody sends them by hand. */
  static final int MOST = 10_000;

  private final String path;
  private final String name;
  private final FieldShape.Many shape;
  private final IntFunction<FormNode> maker;
  private final List<FormNode> elements = new ArrayList<>();

  FormArray(String path, String name, FieldShape.Many shape, IntFunction<FormNode> maker) {
    this.path = path;
    this.name = name;
    this.shape = shape;
    this.maker = maker;
    reset();
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
  public FieldShape.Many shape() {
    return shape;
  }

  List<FormNode> elements() {
    return elements;
  }

  boolean fixed() {
    return shape.size() > 0;
  }

  void add() {
    if (elements.size() < MOST) {
      elements.add(maker.apply(elements.size()));
    }
  }

  /** Removes one; those behind it move up. */
  void remove(int index) {
    elements.remove(index);
    for (int i = index; i < elements.size(); i++) {
      elements.set(i, moved(elements.get(i), i));
    }
  }

  private FormNode moved(FormNode from, int index) {
    FormNode to = maker.apply(index);
    FormCopy.copy(from, to);
    return to;
  }

  @Override
  public List<Object> value() {
    return elements.stream().map(FormNode::value).toList();
  }

  @Override
  public void problems(List<FormProblem> into) {
    elements.forEach(element -> element.problems(into));
  }

  @Override
  public void reset() {
    elements.clear();
    while (elements.size() < Math.min(shape.size(), MOST)) {
      add();
    }
  }

  @Override
  public void fill(FieldValue value) {
    reset();
    if (value instanceof FieldValue.Items items) {
      int count = Math.min(MOST, fixed() ? Math.min(elements.size(), items.values().size()) : items.values().size());
      for (int i = 0; i < count; i++) {
        if (i == elements.size()) {
          add();
        }
        elements.get(i).fill(items.values().get(i));
      }
    }
  }
}
