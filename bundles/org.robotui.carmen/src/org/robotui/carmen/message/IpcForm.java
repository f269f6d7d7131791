package org.robotui.carmen.message;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import org.robotui.carmen.format.FormatText;
import org.robotui.carmen.format.IpcFormat;
import org.robotui.carmen.format.IpcFormatException;

/**
 * What messages of a name consist of. On the wire a message that has fields begins with the number of their bytes,
 * twice.
 *
 * @param name of the messages
 * @param text the format as it is registered
 * @param format the same
 * @param fields how its fields are called
 */
public record IpcForm(String name, String text, IpcFormat format, List<FieldName> fields) {

  /** Checks that each field has a name. */
  public IpcForm {
    fields = List.copyOf(fields);
    if (!FieldName.fit(fields, format)) {
      throw new IllegalArgumentException(name + ": the names of its fields do not fit its format " + format);
    }
  }

  /**
   * A form whose fields have the names that are given.
   *
   * @param name of the messages
   * @param text its format
   * @param fields names as {@link FieldName#parse} reads them
   * @return the form
   * @throws IllegalArgumentException where the format is none, or the names do not fit it
   */
  public static IpcForm of(String name, String text, String fields) {
    try {
      return new IpcForm(name, text, FormatText.parse(text), FieldName.parse(fields));
    } catch (IpcFormatException e) {
      throw new IllegalArgumentException(name + ": " + e.getMessage(), e);
    }
  }

  /**
   * A form without names: the fields are numbered.
   *
   * @param name of the messages
   * @param format of which
   * @return the form
   */
  public static IpcForm numbered(String name, IpcFormat format) {
    return new IpcForm(name, format.toString(), format, FieldName.numbered(format));
  }

  /**
   * Whether its messages have no fields.
   *
   * @return then nothing is sent but the header
   */
  public boolean isEmpty() {
    return format instanceof IpcFormat.Nothing;
  }

  /**
   * Reads a message.
   *
   * @param body the data of a frame, in its order of bytes
   * @return its fields
   * @throws IpcFormatException where it does not fit; names the message
   */
  public IpcRecord read(ByteBuffer body) throws IpcFormatException {
    try {
      ByteBuffer in = body.slice().order(body.order());
      if (isEmpty()) {
        return IpcRecordReader.read(format, fields, in);
      }
      if (in.remaining() < 2 * Integer.BYTES) {
        throw new IpcFormatException("a message of " + in.remaining() + " bytes has no length");
      }
      int length = in.getInt();
      if (length != in.remaining() - Integer.BYTES || in.getInt() != length) {
        throw new IpcFormatException("a message of " + body.remaining() + " bytes says that it has " + length);
      }
      return IpcRecordReader.read(format, fields, in);
    } catch (IpcFormatException e) {
      throw new IpcFormatException(name + ": " + e.getMessage());
    }
  }

  /**
   * Writes a message.
   *
   * @param record its fields
   * @param order of bytes
   * @return the data of a frame
   * @throws IllegalArgumentException where the record does not fit; names the message
   */
  public byte[] write(IpcRecord record, ByteOrder order) {
    if (isEmpty()) {
      return new byte[0];
    }
    try {
      byte[] content = IpcRecordWriter.write(format, record, order);
      return ByteBuffer.allocate(2 * Integer.BYTES + content.length).order(order).putInt(content.length)
          .putInt(content.length).put(content).array();
    } catch (IllegalArgumentException e) {
      throw new IllegalArgumentException(name + ": " + e.getMessage(), e);
    }
  }

  /**
   * Reads a message of a central's own, which has no length before it.
   *
   * @param body the data of a frame, in its order of bytes
   * @return its fields
   * @throws IpcFormatException where it does not fit; names the message
   */
  public IpcRecord readBare(ByteBuffer body) throws IpcFormatException {
    try {
      return IpcRecordReader.read(format, fields, body.slice().order(body.order()));
    } catch (IpcFormatException e) {
      throw new IpcFormatException(name + ": " + e.getMessage());
    }
  }

  /**
   * Writes a message of a central's own.
   *
   * @param record its fields
   * @param order of bytes
   * @return the data of a frame
   */
  public byte[] writeBare(IpcRecord record, ByteOrder order) {
    return IpcRecordWriter.write(format, record, order);
  }

  /**
   * Begins a message of it.
   *
   * @return without values: numbers are 0, texts and arrays empty
   */
  public IpcRecordMaker make() {
    return new IpcRecordMaker(this);
  }
}
