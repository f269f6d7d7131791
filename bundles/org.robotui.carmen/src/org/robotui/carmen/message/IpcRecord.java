package org.robotui.carmen.message;

import java.util.List;
import java.util.Optional;

/**
 * A message or a structure in one.
 *
 * @param names of its fields, in their order
 * @param values of its fields, as many
 */
public record IpcRecord(List<FieldName> names, List<IpcValue> values) {

  /** Without any field. */
  public static final IpcRecord EMPTY = new IpcRecord(List.of(), List.of());

  /** Copies both lists; each field has a name. */
  public IpcRecord {
    names = List.copyOf(names);
    values = List.copyOf(values);
    if (names.size() != values.size()) {
      throw new IllegalArgumentException(values.size() + " values have " + names.size() + " names");
    }
  }

  /**
   * A field.
   *
   * @param name as in {@link FieldName}
   * @return its value; empty where there is no such field
   */
  public Optional<IpcValue> field(String name) {
    for (int i = 0; i < names.size(); i++) {
      if (names.get(i).name().equals(name)) {
        return Optional.of(values.get(i));
      }
    }
    return Optional.empty();
  }

  /**
   * A field that is a number.
   *
   * @param name which
   * @return not a number where it is none, or not there
   */
  public double number(String name) {
    return field(name).map(IpcValue::number).orElse(Double.NaN);
  }

  /**
   * A field that is a whole number.
   *
   * @param name which
   * @return 0 where it is none, or not there
   */
  public int whole(String name) {
    return field(name).orElse(new IpcValue.Absent()) instanceof IpcValue.Whole w ? w.value() : 0;
  }

  /**
   * A field that is a text.
   *
   * @param name which
   * @return empty where it is none, or not there
   */
  public String text(String name) {
    return field(name).orElse(new IpcValue.Absent()) instanceof IpcValue.Text t ? t.value() : "";
  }

  /**
   * A field that is a structure.
   *
   * @param name which
   * @return without fields where it is none, or not there
   */
  public IpcRecord record(String name) {
    return field(name).orElse(new IpcValue.Absent()) instanceof IpcValue.Members m ? m.record() : EMPTY;
  }

  /**
   * A field that is an array of structures.
   *
   * @param name which
   * @return empty where it is none, or not there
   */
  public List<IpcRecord> records(String name) {
    return field(name).orElse(new IpcValue.Absent()) instanceof IpcValue.Items items
        ? items.values().stream().filter(IpcValue.Members.class::isInstance)
            .map(each -> ((IpcValue.Members) each).record()).toList()
        : List.of();
  }

  /**
   * A field that is an array of numbers of 32 bits.
   *
   * @param name which
   * @return a copy; empty where it is none, or not there
   */
  public float[] floats(String name) {
    return field(name).orElse(new IpcValue.Absent()) instanceof IpcValue.Smalls s ? s.values().clone() : new float[0];
  }

  /**
   * A field that is an array of numbers of 64 bits.
   *
   * @param name which
   * @return a copy; empty where it is none, or not there
   */
  public double[] doubles(String name) {
    return field(name).orElse(new IpcValue.Absent()) instanceof IpcValue.Reals r ? r.values().clone() : new double[0];
  }

  /**
   * A field that is an array of bytes.
   *
   * @param name which
   * @return a copy; empty where it is none, or not there
   */
  public byte[] octets(String name) {
    return field(name).orElse(new IpcValue.Absent()) instanceof IpcValue.Octets o ? o.values().clone() : new byte[0];
  }

  /**
   * A field that is an array of texts.
   *
   * @param name which
   * @return empty where it is none, or not there
   */
  public List<String> texts(String name) {
    return field(name).orElse(new IpcValue.Absent()) instanceof IpcValue.Items items
        ? items.values().stream().filter(IpcValue.Text.class::isInstance).map(each -> ((IpcValue.Text) each).value())
            .toList()
        : List.of();
  }
}
