package org.robotui.ui.control;

import org.robotui.data.record.FieldValue;

/**
 * A line of the tree of a record: a field, an element, or a page of elements.
 *
 * @param path where it is, for example {@code poses[3].position}; of a page with both ends, {@code ranges[0..99]}
 * @param depth 0 for the record's own fields
 * @param name its last step
 * @param value what the field or element holds; of a page, what holds the elements
 * @param from of a page, its first element
 * @param to of a page, after its last element; 0 for what is no page
 * @param expanded whether what is within is seen
 */
record RecordRow(String path, int depth, String name, FieldValue value, int from, int to, boolean expanded) {
  static RecordRow of(String path, int depth, String name, FieldValue value) {
    return new RecordRow(path, depth, name, value, 0, 0, false);
  }

  boolean isPage() {
    return to > 0;
  }

  boolean expandable() {
    return switch (value) {
      case FieldValue.Nested n -> true;
      case FieldValue.Numbers n -> n.values().size() > 0;
      case FieldValue.Items i -> !i.values().isEmpty();
      default -> false;
    };
  }

  RecordRow expanded(boolean open) {
    return new RecordRow(path, depth, name, value, from, to, open);
  }

  /** What a path for the robot would be; a page has none of its own, its array has. */
  String fieldPath() {
    return isPage() ? path.substring(0, path.lastIndexOf('[')) : path;
  }
}
