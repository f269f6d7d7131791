package org.robotui.message;

/**
 * Writes the fields of one type from a record. What writes records is made when they are first written, in the package
 * of the record, which is why this class is to be seen from there.
 */
public abstract class BoundWriter {

  /** What is not written down in the code itself: writers of arrays and of fields that the record leaves out. */
  protected final Object[] parts;

  /**
   * Keeps the parts.
   *
   * @param parts what the code refers to
   */
  protected BoundWriter(Object[] parts) {
    this.parts = parts;
  }

  /**
   * Writes the fields.
   *
   * @param value the record
   * @param out where its fields go
   */
  public abstract void write(Object value, FieldWriter out);
}
