package org.robotui.message;

/**
 * Reads the fields of one type into a record. What reads records is made when they are bound, in the package of the
 * record, which is why this class is to be seen from there.
 */
public abstract class BoundReader {

  /**
   * What is not written down in the code itself: readers of arrays, fields that are passed over, values of fields that
   * are missing.
   */
  protected final Object[] parts;

  /**
   * Keeps the parts.
   *
   * @param parts what the code refers to
   */
  protected BoundReader(Object[] parts) {
    this.parts = parts;
  }

  /**
   * Reads the fields.
   *
   * @param in at the first field
   * @return the record
   * @throws MessageException if the bytes are no such message
   */
  public abstract Object read(FieldReader in) throws MessageException;
}
